// How a run stands, as run.json and the closing line describe it.
#include "run/host/run_status.hpp"

#include <gtest/gtest.h>

#include <regex>

namespace softwet {
namespace {

std::string json_of(const RunStatus& status) {
  RunRecord run;
  add_status(run, status);
  return run.json();
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(RunStatus, TheStateFollowsTheReason) {
  EXPECT_TRUE(has(json_of({"running", 0, 0, {}, {}}), R"("state": "running")"));
  EXPECT_TRUE(has(json_of({"end reached", 0, 0, {}, {}}), R"("state": "done")"));
  EXPECT_TRUE(has(json_of({"time.max_steps reached", 0, 0, {}, {}}), R"("state": "stopped")"));
  EXPECT_TRUE(has(json_of({"stopped by user", 0, 0, {}, {}}), R"("state": "stopped")"));
  EXPECT_TRUE(has(json_of({"failed: the disk is full", 0, 0, {}, {}}), R"("state": "failed")"));
}

TEST(RunStatus, TimesAreUtc) {
  EXPECT_EQ(utc_text(0), "1970-01-01T00:00:00Z");
  EXPECT_EQ(utc_text(951827696.7), "2000-02-29T12:34:56Z");
  const std::string text = json_of({"running", 2.5, 951827696, {}, {}});
  EXPECT_TRUE(has(text, R"("started": "2000-02-29T12:34:56Z")")) << text;
  EXPECT_TRUE(std::regex_search(text, std::regex(R"("updated": "20\d\d-\d\d-\d\dT\d\d:\d\d:\d\dZ")"))) << text;
  EXPECT_TRUE(has(text, R"("t": 2.5)")) << text;
}

TEST(RunStatus, SecondsLeftAreNullWhereNobodyKnows) {
  EXPECT_TRUE(has(json_of({"running", 0, 0, 12.5, {}}), R"("seconds_left": 12.5)"));
  EXPECT_TRUE(has(json_of({"running", 0, 0, {}, {}}), R"("seconds_left": null)"));
  EXPECT_TRUE(has(json_of({"stopped by user", 0, 0, 12.5, {}}), R"("seconds_left": null)"));
}

TEST(RunStatus, EventsAreListedAndSummedUp) {
  const std::vector<Event> events{{-1.5, "droplet 1 and droplet 2 merged"}, {3.25, "droplet 1 reached the top"}};
  const std::string text = json_of({"end reached", 4, 0, {}, events});
  EXPECT_TRUE(has(text, R"("t": -1.5)") && has(text, R"("what": "droplet 1 reached the top")")) << text;
  EXPECT_TRUE(has(json_of({"running", 0, 0, {}, {}}), R"("events": [])"));
  EXPECT_EQ(summary({}), "");
  EXPECT_EQ(summary(events), "; at t = -1.5 droplet 1 and droplet 2 merged; at t = 3.25 droplet 1 reached the top");
  EXPECT_TRUE(
      has(summary(std::vector<Event>(5, {1, "the droplet vanished"})), "; and 2 more events, listed in run.json"));
}

TEST(RunStatus, SaysHowFarAStartAtRestMovedThings) {
  EXPECT_EQ(moves_text({}, {}), "");
  EXPECT_EQ(moves_text({"the droplet"}, {std::nullopt}), "");
  EXPECT_EQ(moves_text({"the droplet", "the film"}, {0.01234, 0.5}),
            "; on the way the droplet moved by 0.012, the film moved by 0.5");
  std::vector<std::string> names;
  for (int k = 1; k <= 6; ++k) names.push_back("droplet " + std::to_string(k));
  EXPECT_EQ(moves_text(names, {0.1, std::nullopt, 0.3, 0.2, 0, 0}),
            "; on the way droplet 3 moved farthest, by 0.3 (run.json has all: start.moved)");
}

}  // namespace
}  // namespace softwet
