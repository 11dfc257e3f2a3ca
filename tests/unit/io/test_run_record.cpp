// run.json: order, nesting, escaping and numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "io/json_text.hpp"
#include "io/run_record.hpp"
#include "scratch_folder.hpp"

namespace softwet {
namespace {

TEST(JsonText, EscapesWhatJsonWantsEscaped) {
  EXPECT_EQ(json_string("a\"b\\c\n\t\r"), R"("a\"b\\c\n\t\r")");
  EXPECT_EQ(json_string(std::string("\x01\0", 2)), R"("\u0001\u0000")");
  EXPECT_EQ(json_string("\xC3\xA9 \xE2\x82\xAC \xF0\x9F\x92\xA7"), "\"\xC3\xA9 \xE2\x82\xAC \xF0\x9F\x92\xA7\"");
}

TEST(JsonText, ReplacesBytesThatAreNotUtf8) {
  EXPECT_EQ(json_string("a\xFF"
                        "b"),
            R"("a\ufffdb")");
  EXPECT_EQ(json_string("\xC3"), R"("\ufffd")");
  EXPECT_EQ(json_string("\xC0\x80"), R"("\ufffd\ufffd")");            // overlong
  EXPECT_EQ(json_string("\xED\xA0\x80"), R"("\ufffd\ufffd\ufffd")");  // surrogate
}

TEST(RunRecord, KeepsOrderAndTypes) {
  RunRecord record;
  record["version"] = "0.1";
  record["threads"] = 2;
  record["resumed"] = false;
  record["timings"]["residual"] = 2.0;
  record["timings"]["total"] = 0.1;
  record["stops"].append("end");
  record["stops"].append(std::int64_t{1} << 60);
  record["nothing"] = RecordValue();
  record["empty"] = RecordValue::List{};
  record["threads"] = std::size_t{4};
  EXPECT_EQ(record.json(), R"({
  "version": "0.1",
  "threads": 4,
  "resumed": false,
  "timings": {
    "residual": 2.0,
    "total": 0.1
  },
  "stops": [
    "end",
    1152921504606846976
  ],
  "nothing": {},
  "empty": []
}
)");
}

TEST(RunRecord, ReferencesStayValidWhenKeysAreAdded) {
  RunRecord record;
  RecordValue& timings = record["timings"];
  for (int i = 0; i < 100; ++i) record["key_" + std::to_string(i)] = i;
  timings["total"] = 1.5;
  EXPECT_NE(record.json().find("\"total\": 1.5"), std::string::npos);
}

TEST(RunRecord, WritesNumbersThatAreNotFiniteAsNull) {
  RunRecord record;
  record["residual"] = std::numeric_limits<double>::infinity();
  record["rate"] = std::nan("");
  EXPECT_EQ(record.json(), "{\n  \"residual\": null,\n  \"rate\": null\n}\n");
}

TEST(RunRecord, ReplacesTheFile) {
  const ScratchFolder folder;
  const std::string path = folder / "run.json";
  overwrite(path, "old");
  RunRecord record;
  record["a"] = 1e-7;
  record.write(path);
  EXPECT_EQ(content_of(path), "{\n  \"a\": 1e-07\n}\n");
}

}  // namespace
}  // namespace softwet
