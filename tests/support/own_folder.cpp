// Part of every test program: the folder that testing::TempDir() names is this process's own, and goes with
// it. Tests run side by side, each in a process, and two that write a file of one name must not meet.
#include <cstdlib>

#include "tests/support/run_program.h"

namespace {

struct OwnFolder {
  OwnFolder() { setenv("TEST_TMPDIR", folder.path().c_str(), 1); }
  const lodestone::test::TemporaryFolder folder;
};

const OwnFolder ownFolder;

}  // namespace
