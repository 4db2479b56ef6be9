#include "model/io/flight_json.h"

#include <gtest/gtest.h>

namespace lodestone {
namespace {

TEST(FlightJson, IsTheSameAfterItWasWrittenAndRead) {
  FlightPath path;
  for (int i = 0; i < 5; ++i)
    path.keys.push_back(
        {0.1 * i * i - 0.3 + i, {599931.123 + i, 5700000.7 / (i + 1), 1.0 / 3}, {i + 0.1, 2, 3}, 44.5 + i});
  const Result<FlightPath> read = parseFlightPath(flightPathText(path));
  ASSERT_TRUE(read);
  EXPECT_TRUE(read.diagnostics.empty());
  EXPECT_EQ(*read, path);
}

TEST(FlightJson, WithoutTimesFollowsItsSpeed) {
  const Result<FlightPath> path = parseFlightPath(
      R"({"type": "path", "version": 1, "speed": 5, "keys": [
          {"eye": [0, 0, 10], "target": [1, 0, 10]}, {"eye": [30, 40, 10], "target": [1, 0, 10], "fov": 75},
          {"eye": [30, 40, 20], "target": [1, 0, 10]}]})");
  ASSERT_TRUE(path);
  EXPECT_DOUBLE_EQ(path->keys[1].time, 10);
  EXPECT_DOUBLE_EQ(path->duration(), 12);
  EXPECT_EQ(path->keys[0].fov, 45);
  EXPECT_EQ(path->keys[1].fov, 75);
}

TEST(FlightJson, SaysWhatIsWrongWithAFile) {
  const auto whyNot = [](const std::string& keys, const std::string& more = "") {
    const auto path = parseFlightPath(R"({"type": "path", "version": 1, "keys": )" + keys + more + "}");
    return path ? std::string() : path.diagnostics.front().text;
  };
  const std::string a = R"({"t": 1, "eye": [0, 0, 0], "target": [1, 0, 0]})";
  const std::string untimed = R"({"eye": [5, 0, 0], "target": [1, 0, 0]})";
  EXPECT_EQ(whyNot("[" + a + "]"), "");
  EXPECT_NE(whyNot("[]").find("no \"keys\""), std::string::npos);
  EXPECT_NE(whyNot("[" + a + "," + a + "]").find("key 2 is not later"), std::string::npos);
  EXPECT_NE(whyNot("[" + a + "," + untimed + "]").find("others have none"), std::string::npos);
  EXPECT_NE(whyNot("[" + untimed + "," + untimed + "]").find("stand in one place"), std::string::npos);
  EXPECT_NE(whyNot("[" + untimed + "]", R"(, "speed": 0)").find("\"speed\""), std::string::npos);
  EXPECT_NE(whyNot(R"([{"eye": [0, 0], "target": [1, 0, 0]}])").find("key 1 wants"), std::string::npos);
  EXPECT_NE(whyNot(R"([{"eye": [1, 0, 0], "target": [1, 0, 0]}])").find("where its eye is"),
            std::string::npos);
  EXPECT_NE(whyNot(R"([{"eye": [1, 0, 0], "target": [1, 1, 0], "fov": 200}])").find("field of view"),
            std::string::npos);
  EXPECT_FALSE(parseFlightPath("{"));
  EXPECT_FALSE(parseFlightPath(R"({"type": "cut"})"));
}

}  // namespace
}  // namespace lodestone
