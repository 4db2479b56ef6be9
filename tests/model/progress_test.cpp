#include "model/progress.h"

#include <thread>
#include <vector>

#include <gmock/gmock.h>

namespace lodestone {
namespace {

TEST(Progress, PartsFillTheirWindowOfOneBar) {
  std::vector<std::pair<double, std::string>> seen;
  const Progress whole([&](double done, const std::string& stage) { seen.emplace_back(done, stage); });
  const Progress first = whole.part(0, 0.5, "read");
  first.report(0.5);
  first.report(1);
  whole.part(0.5, 1, "cluster").part(0.5, 1).report(0.5);
  const std::vector<std::pair<double, std::string>> wanted{
      {0, "read"}, {0.25, "read"}, {0.5, "read"}, {0.5, "cluster"}, {0.75, "cluster"}, {0.875, "cluster"}};
  EXPECT_EQ(seen, wanted);
}

TEST(Progress, NeverFallsAndDropsStepsThatNobodySees) {
  std::vector<double> seen;
  const Progress progress([&](double done, const std::string&) { seen.push_back(done); });
  progress.report(0.5);
  progress.report(0.2);
  for (int i = 0; i < 100; ++i) progress.report(0.5 + i * 1e-6);
  progress.report(1);
  EXPECT_THAT(seen, testing::ElementsAre(0.5, 1.0));
}

TEST(Progress, CancelReachesEveryPart) {
  std::stop_source stop;
  const Progress progress({}, stop.get_token());
  const Progress deep = progress.part(0, 0.5, "a").part(0.1, 0.2, "b");
  EXPECT_NO_THROW(deep.checkpoint());
  EXPECT_FALSE(deep.stopRequested());
  stop.request_stop();
  EXPECT_TRUE(deep.stopRequested());
  EXPECT_THROW(deep.checkpoint(), Cancelled);
}

TEST(Progress, ReportsComeOneAtATimeFromManyThreads) {
  int running = 0;
  int mostAtOnce = 0;
  std::vector<double> seen;
  const Progress progress([&](double done, const std::string&) {
    mostAtOnce = std::max(mostAtOnce, ++running);
    seen.push_back(done);
    --running;
  });
  {
    std::vector<std::jthread> threads;
    for (int t = 0; t < 4; ++t) {
      threads.emplace_back([&] {
        for (int i = 0; i <= 1000; ++i) progress.report(i / 1000.0);
      });
    }
  }
  EXPECT_EQ(mostAtOnce, 1);
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_EQ(seen.back(), 1.0);
}

}  // namespace
}  // namespace lodestone
