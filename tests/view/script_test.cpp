#include "view/script.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace cleave {
namespace {

std::string refusal(const std::string& text) {
    try {
        parseScript(text, "a.txt");
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(Script, ReadsEachKindOfStep) {
    const std::vector<ScriptStep> steps = parseScript(
        "# a comment\n\n  size 640 360\neye 1 -2 3e-1\r\ndrag left 1 2 3 4\nwait idle\nwait frames 12\n"
        "drop a file with blanks.glb \nexpect error\npanels on\nscreenshot x.png\nquit\n",
        "a.txt");
    ASSERT_EQ(steps.size(), 10u);
    EXPECT_EQ(steps[0].verb, Verb::size);
    EXPECT_EQ(steps[0].line, 3u);
    EXPECT_EQ(steps[0].numbers[1], 360.0);
    EXPECT_EQ(steps[1].numbers[2], 0.3);
    EXPECT_EQ(steps[2].text, "left");
    EXPECT_EQ(steps[2].numbers[3], 4.0);
    EXPECT_EQ(steps[3].verb, Verb::waitIdle);
    EXPECT_EQ(steps[4].numbers[0], 12.0);
    EXPECT_EQ(steps[5].text, "a file with blanks.glb");
    EXPECT_EQ(steps[6].verb, Verb::expectError);
    EXPECT_EQ(steps[7].numbers[0], 1.0);
    EXPECT_EQ(steps[9].verb, Verb::quit);
}

TEST(Script, RefusesWhatIsNoStepAndSaysWhere) {
    EXPECT_NE(refusal("size 10 10\njump 3\n").find("a.txt, line 2: 'jump' is no step; there are: size, eye,"),
              std::string::npos);
    EXPECT_NE(refusal("wait\n").find("line 1"), std::string::npos);
    for (const char* wrong : {"size 10", "size 10 10 10", "eye 1 2 x", "eye 1 2 nan", "drag left 1 2 3", "drag 1 2 3 4",
                              "panels maybe", "wait frames", "key", "screenshot", "quit now", "wait idle 3"})
        EXPECT_NE(refusal(wrong).find("line 1: a step of this kind is: "), std::string::npos) << wrong;
    EXPECT_THROW(readScript("/nowhere/script.txt"), Error);
}

}  // namespace
}  // namespace cleave
