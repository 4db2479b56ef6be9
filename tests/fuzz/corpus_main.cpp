// Runs a fuzz target over a stored corpus without libFuzzer: each file as it is, cut off at every length, and
// with each byte changed in a few ways. Every build can run it.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

void run(const std::string& bytes) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::filesystem::path> files;
  for (int i = 1; i < argc; ++i) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(argv[i])) {
      if (entry.is_regular_file()) files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  std::size_t runs = 0;
  for (const auto& path : files) {
    std::ifstream file(path, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(file)), {});
    run(bytes);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      run(bytes.substr(0, i));
      constexpr std::array<char, 4> kOthers{'\0', '<', '9', '\xFF'};
      std::string changed = bytes;
      changed[i] = kOthers[i % kOthers.size()];
      run(changed);
      runs += 2;
    }
  }
  std::printf("%zu files, %zu changed inputs\n", files.size(), runs);
  return files.empty() ? 1 : 0;
}
