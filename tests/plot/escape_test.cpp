#include "plot/escape.h"

#include <gtest/gtest.h>

namespace cleave::test {
namespace {

TEST(Escaped, MarkUpBecomesText) {
    EXPECT_EQ(escaped("plain text, 12.5 %"), "plain text, 12.5 %");
    EXPECT_EQ(escaped("<b a=\"1\" c='2'>&amp;</b>"), "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt;&amp;amp;&lt;/b&gt;");
    EXPECT_EQ(escaped(""), "");
}

TEST(Escaped, ControlCharactersBecomeSpaces) {
    using namespace std::string_literals;
    EXPECT_EQ(escaped("a\nb\0c\x7F"s), "a b c ");
}

TEST(Escaped, OnlyWellFormedUtf8Passes) {
    EXPECT_EQ(escaped("\u00E9\u2013\U0001F600"), "\u00E9\u2013\U0001F600");
    EXPECT_EQ(escaped("\xFF"
                      "a"),
              "\uFFFDa");
    EXPECT_EQ(escaped("\xC3"), "\uFFFD") << "cut short";
    EXPECT_EQ(escaped("\xC0\xBC"), "\uFFFD\uFFFD") << "an overlong <";
    EXPECT_EQ(escaped("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD") << "a surrogate";
    EXPECT_EQ(escaped("\xF4\x90\x80\x80"), "\uFFFD\uFFFD\uFFFD\uFFFD") << "beyond U+10FFFF";
}

}  // namespace
}  // namespace cleave::test
