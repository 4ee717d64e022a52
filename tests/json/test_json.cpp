// JSON values are written as they were put together, and read as they were written.

#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/json/json.hpp>
#include <limits>

namespace leadscrew::json::testing {
namespace test_json {

TEST(Written, HasMembersInTheirOrder) {
  Json json = Json::object({{"z", 1}, {"a", Json::list({1.5, "two", nullptr})}, {"m", Json::object({{"yes", true}})}});
  json["b"] = std::vector<double>{1, 0.25};
  json["z"] = std::optional<int>();
  EXPECT_EQ(json.written_in_line(), R"({"z":null,"a":[1.5,"two",null],"m":{"yes":true},"b":[1.0,0.25]})");
  EXPECT_EQ(Json::object({{"a", Json::list({1})}}).written(), "{\n  \"a\": [\n    1\n  ]\n}");
  EXPECT_EQ(Json::object().written(), "{}");
  EXPECT_EQ(Json::list().written(), "[]");
}

TEST(Written, KeepsEveryBitOfNumbers) {
  for (const double value : {0.1, 1e300, 5e-324, -0.0, 123456789.123456789, 1e15, 1e16}) {
    const auto read = Json::parse(Json::list({value}).written());
    ASSERT_TRUE(read);
    EXPECT_EQ(read->values()->front().number(), value);
  }
  EXPECT_EQ(Json(std::numeric_limits<std::uint64_t>::max()).written(), "18446744073709551615");
  EXPECT_EQ(Json(std::numeric_limits<std::int64_t>::min()).written(), "-9223372036854775808");
  EXPECT_EQ(Json(NAN).written(), "null");
}

TEST(Written, IsUtf8WhateverTheTextIs) {
  EXPECT_EQ(Json("a\xff\"\n").written(), "\"a\xef\xbf\xbd\\\"\\n\"");
}

TEST(Read, GivesItsParts) {
  const auto read = Json::parse(R"({"text": "t", "count": 7, "number": 0.5, "list": [1, 2], "none": null})");
  ASSERT_TRUE(read);
  EXPECT_EQ(*read->find("text")->text(), "t");
  EXPECT_EQ(read->find("count")->integer(), 7);
  EXPECT_EQ(read->find("count")->number(), 7.0);
  EXPECT_EQ(read->find("number")->integer(), std::nullopt);
  EXPECT_EQ(read->find("list")->values()->size(), 2u);
  EXPECT_EQ(read->find("list")->text(), nullptr);
  EXPECT_EQ(read->find("absent"), nullptr);
  EXPECT_EQ(Json::parse("18446744073709551615")->integer(), std::nullopt);
}

TEST(Read, RefusesWhatIsNoJson) {
  EXPECT_FALSE(Json::parse(""));
  EXPECT_FALSE(Json::parse("{\"a\": 1"));
  EXPECT_FALSE(Json::parse("[1] x"));
  EXPECT_TRUE(Json::parse(std::string(60, '[') + std::string(60, ']')));
  EXPECT_FALSE(Json::parse(std::string(100'000, '[') + std::string(100'000, ']')));
}

}  // namespace test_json
}  // namespace leadscrew::json::testing
