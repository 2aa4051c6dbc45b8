#include "formats/base64.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace cleave::test {
namespace {

std::span<const std::byte> bytesOf(std::string_view text) { return std::as_bytes(std::span(text.data(), text.size())); }

// RFC 4648, section 10.
TEST(Base64, OfTheStandardsExamples) {
    for (const auto& [plain, encoded] : std::vector<std::pair<std::string, std::string>>{{"", ""},
                                                                                         {"f", "Zg=="},
                                                                                         {"fo", "Zm8="},
                                                                                         {"foo", "Zm9v"},
                                                                                         {"foob", "Zm9vYg=="},
                                                                                         {"fooba", "Zm9vYmE="},
                                                                                         {"foobar", "Zm9vYmFy"},
                                                                                         {"\xFB\xFF\xBE", "+/++"}}) {
        EXPECT_EQ(base64Of(bytesOf(plain)), encoded);
        const std::vector<std::byte> back = bytesOfBase64(encoded);
        EXPECT_TRUE(std::equal(back.begin(), back.end(), bytesOf(plain).begin(), bytesOf(plain).end())) << plain;
    }
}

TEST(Base64, RefusesWhatItIsNot) {
    EXPECT_THROW(bytesOfBase64("Zg="), Error);
    EXPECT_THROW(bytesOfBase64("Zm9\x80"), Error);
    EXPECT_THROW(bytesOfBase64("Z==="), Error);
}

}  // namespace
}  // namespace cleave::test
