#include "formats/write_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>

#include "base/error.h"
#include "support/program.h"

namespace cleave::test {
namespace {

namespace fs = std::filesystem;

std::string failureOf(const fs::path& file) {
    try {
        writeFile(file, std::string_view("x"));
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(WriteFile, WritesAndReplaces) {
    const TemporaryFolder folder;
    writeFile(folder / "a", std::string_view("first"));
    EXPECT_EQ(contentOf(folder / "a"), "first");
    writeFile(folder / "a", std::string_view("2"));
    EXPECT_EQ(contentOf(folder / "a"), "2");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"a"});
}

TEST(WriteFile, RefusesFoldersAndPlacesThatAreNotThere) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "d");
    EXPECT_NE(failureOf(folder / "d").find("it is a folder"), std::string::npos);
    EXPECT_NE(failureOf(folder / "no" / "a").find("there is no folder"), std::string::npos);
    EXPECT_THROW(requireWritable(folder / "no" / "a"), Error);
    EXPECT_THROW(requireWritable(folder / "d"), Error);
    EXPECT_NO_THROW(requireWritable(folder / "a"));
    EXPECT_FALSE(fs::exists(folder / "a")) << "asking must not create the file";
}

TEST(WriteFile, FollowsALinkAndLeavesIt) {
    const TemporaryFolder folder;
    put(folder / "real", "old");
    fs::create_symlink(folder / "real", folder / "link");
    writeFile(folder / "link", std::string_view("new"));
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(contentOf(folder / "real"), "new");
}

TEST(WriteFile, WritesIntoADeviceWithoutReplacingIt) {
    const TemporaryFolder folder;
    const fs::path pipe = folder / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
    ASSERT_GE(reader, 0);
    writeFile(pipe, std::string_view("through"));
    char text[16] = {};
    EXPECT_EQ(read(reader, text, sizeof text), 7);
    EXPECT_STREQ(text, "through");
    close(reader);
    EXPECT_TRUE(fs::is_fifo(pipe));
}

// In a process of its own: writes until a limit on file sizes stops it, or a signal does.
int writeMuch(const fs::path& file, bool interrupt) {
    const pid_t child = fork();
    if (child == 0) {
        rlimit limit{1 << 20, 1 << 20};
        setrlimit(RLIMIT_FSIZE, &limit);
        // Beyond the limit the kernel sends SIGXFSZ. Ignored, the write fails; turned into Ctrl-C, it is interrupted
        // with the file half written.
        std::signal(SIGXFSZ, interrupt ? [](int) { raise(SIGINT); } : SIG_IGN);
        try {
            writeFile(file, std::string(8 << 20, 'x'));
        } catch (const Error&) {
            _exit(1);
        }
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

TEST(WriteFile, KeepsTheOldFileAndLeavesNoPartWhenTheDiskIsFull) {
    const TemporaryFolder folder;
    put(folder / "a", "old");
    EXPECT_EQ(writeMuch(folder / "a", false), 1);
    EXPECT_EQ(contentOf(folder / "a"), "old");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"a"});
}

TEST(WriteFile, LeavesNoPartOnCtrlC) {
    const TemporaryFolder folder;
    EXPECT_EQ(writeMuch(folder / "a", true), 128 + SIGINT);
    EXPECT_EQ(folder.names(), std::vector<std::string>{});
}

}  // namespace
}  // namespace cleave::test
