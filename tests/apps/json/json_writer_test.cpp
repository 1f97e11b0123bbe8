#include "apps/json/json_writer.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <stdexcept>
#include <string>

namespace swirl::tests {
namespace {

using apps::JsonError;
using apps::JsonLayout;
using apps::JsonWriter;
using nlohmann::json;

template <class Value>
std::string text_of(const Value& value) {
    std::string text;
    JsonWriter writer(text);
    writer.value(value);
    writer.finish();
    return text;
}

void expect_same_bits(double value) {
    const double read = json::parse(text_of(value)).get<double>();
    ASSERT_EQ(std::bit_cast<std::uint64_t>(read), std::bit_cast<std::uint64_t>(value)) << text_of(value);
}

TEST(JsonWriter, DoublesKeepTheirBits) {
    using Limits = std::numeric_limits<double>;
    for (const double value :
         {0.0, -0.0, 1.0, 0.5, -1.0 / 3, 1e22, 1e23, 1e300, 123456789012345678.0, 0.1, Limits::max(), Limits::lowest(),
          Limits::min(), Limits::denorm_min(), -Limits::denorm_min(), 1e-310}) {
        expect_same_bits(value);
    }
    std::mt19937_64 random(20240817);
    long finite = 0;
    for (int i = 0; i < 200'000; ++i) {
        const double value = std::bit_cast<double>(random());
        const double subnormal = std::bit_cast<double>(random() & 0x800FFFFFFFFFFFFFU);
        const double ordinary = std::ldexp(static_cast<double>(random()), -60);
        expect_same_bits(subnormal);
        expect_same_bits(ordinary);
        if (!std::isfinite(value)) continue;
        ++finite;
        expect_same_bits(value);
    }
    EXPECT_GT(finite, 190'000);
}

TEST(JsonWriter, NumbersLookAsExpected) {
    EXPECT_EQ(text_of(1.0), "1\n");
    EXPECT_EQ(text_of(0.5), "0.5\n");
    EXPECT_EQ(text_of(-0.0), "-0.0\n");
    EXPECT_EQ(text_of(0.1), "0.1\n");
    EXPECT_EQ(text_of(1e-6), "1e-06\n");
    EXPECT_EQ(text_of(0.1 + 0.2), "0.30000000000000004\n");
    EXPECT_EQ(text_of(std::numeric_limits<double>::lowest()), "-1.7976931348623157e+308\n");
    EXPECT_EQ(text_of(true), "true\n");
    EXPECT_EQ(text_of(7), "7\n");
    EXPECT_EQ(text_of(std::numeric_limits<std::int64_t>::min()), "-9223372036854775808\n");
    EXPECT_EQ(text_of(std::numeric_limits<std::uint64_t>::max()), "18446744073709551615\n");
    EXPECT_EQ(text_of(static_cast<unsigned char>(200)), "200\n");
}

TEST(JsonWriter, WhatIsNotFiniteIsNull) {
    EXPECT_EQ(text_of(std::nan("")), "null\n");
    EXPECT_EQ(text_of(std::numeric_limits<double>::infinity()), "null\n");
    EXPECT_EQ(text_of(-std::numeric_limits<double>::infinity()), "null\n");
}

TEST(JsonWriter, EveryCharacterComesBack) {
    for (int code = 0; code < 128; ++code) {
        const std::string text = "a" + std::string(1, static_cast<char>(code)) + "b";
        EXPECT_EQ(json::parse(text_of(text)).get<std::string>(), text) << code;
    }
    const std::string unicode = "β = ½, ω\u00a0ẑ 𝄞";
    EXPECT_EQ(json::parse(text_of(unicode)).get<std::string>(), unicode);
    EXPECT_EQ(text_of("quote \" and \\"), "\"quote \\\" and \\\\\"\n");
}

TEST(JsonWriter, InvalidUtf8IsReplaced) {
    EXPECT_EQ(json::parse(text_of("a\xFFz")).get<std::string>(), "a\uFFFDz");
    EXPECT_EQ(json::parse(text_of("\xC3")).get<std::string>(), "\uFFFD");            // cut short
    EXPECT_EQ(json::parse(text_of("\xC3(")).get<std::string>(), "\uFFFD(");          // resumes at once
    EXPECT_EQ(json::parse(text_of("\xC0\xAF")).get<std::string>(), "\uFFFD\uFFFD");  // overlong
    EXPECT_EQ(json::parse(text_of("\xED\xA0\x80")).get<std::string>().find("\xED"), std::string::npos);  // surrogate
    std::mt19937 random(3);
    for (int i = 0; i < 20'000; ++i) {
        std::string noise(static_cast<std::size_t>(random() % 8), ' ');
        for (char& byte : noise) byte = static_cast<char>(random());
        EXPECT_TRUE(json::accept(text_of(noise)));
    }
}

TEST(JsonWriter, DocumentsAreLaidOutInRows) {
    std::string text;
    JsonWriter writer(text);
    writer.begin_object(JsonLayout::rows);
    writer.member("outcome", "completed");
    writer.key("collisions");
    writer.begin_array(JsonLayout::rows);
    for (int i = 0; i < 2; ++i) {
        writer.begin_object();
        writer.member("t", 0.5 * i);
        writer.member("vertex", i);
        writer.end_object();
    }
    writer.end_array();
    writer.key("contacts");
    writer.begin_array(JsonLayout::rows);
    writer.end_array();
    writer.key("empty");
    writer.begin_object();
    writer.end_object();
    writer.key("chi");
    writer.null();
    writer.end_object();
    writer.finish();
    EXPECT_EQ(text, R"({
  "outcome": "completed",
  "collisions": [
    {"t": 0, "vertex": 0},
    {"t": 0.5, "vertex": 1}
  ],
  "contacts": [],
  "empty": {},
  "chi": null
}
)");
    EXPECT_EQ(json::parse(text)["collisions"][1]["t"], 0.5);
}

TEST(JsonWriter, CallsOutOfPlaceAreRefused) {
    const auto refused = [](const auto& calls) {
        std::string text;
        JsonWriter writer(text);
        EXPECT_THROW(calls(writer), std::logic_error);
    };
    refused([](JsonWriter& writer) { writer.finish(); });
    refused([](JsonWriter& writer) { writer.key("a"); });
    refused([](JsonWriter& writer) { writer.end_object(); });
    refused([](JsonWriter& writer) { writer.value(1), writer.value(2); });
    refused([](JsonWriter& writer) { writer.begin_object(), writer.value(1); });
    refused([](JsonWriter& writer) { writer.begin_object(), writer.end_array(); });
    refused([](JsonWriter& writer) { writer.begin_object(), writer.key("a"), writer.end_object(); });
    refused([](JsonWriter& writer) { writer.begin_object(), writer.key("a"), writer.key("b"); });
    refused([](JsonWriter& writer) { writer.begin_array(), writer.key("a"); });
    refused([](JsonWriter& writer) { writer.begin_array(), writer.finish(); });
}

void write_million(std::FILE* file) {
    JsonWriter writer(file);
    writer.begin_array(JsonLayout::rows);
    for (int i = 0; i < 1'000'000; ++i) writer.value(i);
    writer.end_array();
    writer.finish();
}

TEST(JsonWriter, LongDocumentsStreamToAFile) {
    std::FILE* file = std::tmpfile();
    ASSERT_NE(file, nullptr);
    write_million(file);
    std::rewind(file);
    const json read = json::parse(file);
    std::fclose(file);
    ASSERT_EQ(read.size(), 1'000'000U);
    EXPECT_EQ(read[999'999], 999'999);
}

TEST(JsonWriter, AFullDiskIsReported) {
    std::FILE* full = std::fopen("/dev/full", "w");
    ASSERT_NE(full, nullptr);
    EXPECT_THROW(write_million(full), JsonError);
    std::fclose(full);
    full = std::fopen("/dev/full", "w");
    JsonWriter writer(full);  // short enough to fail at the very end only
    writer.value(1);
    EXPECT_THROW(writer.finish(), JsonError);
    std::fclose(full);
}

}  // namespace
}  // namespace swirl::tests
