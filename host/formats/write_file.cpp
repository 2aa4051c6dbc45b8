#include "formats/write_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstring>
#include <string>
#include <system_error>

#include "base/error.h"
#include "base/signal_handlers.h"

namespace cleave {
namespace {

namespace fs = std::filesystem;

constexpr std::array kEndingSignals = {SIGINT, SIGTERM, SIGHUP};

// Name of the unfinished file, reachable from a signal handler. Files are written by one thread at a time.
char unfinishedFile[PATH_MAX];

// A signal that ends the program removes the unfinished file first.
void removeUnfinishedAndEnd(int signal) {
    unlink(unfinishedFile);
    std::signal(signal, SIG_DFL);
    raise(signal);
}

[[noreturn]] void failToWrite(const fs::path& file, int error) {
    throw Error("cannot write " + file.string() + ": " + std::generic_category().message(error) +
                "; choose another place or free some space");
}

// Returns 0, or the errno of the failure.
int writeAll(int descriptor, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return errno;
        bytes = bytes.subspan(static_cast<size_t>(written));
    }
    return 0;
}

// Opens, writes, closes; a disk may report only in close() that it is full.
int writeOpened(int descriptor, std::span<const std::byte> bytes) {
    if (descriptor < 0) return errno;
    const int error = writeAll(descriptor, bytes);
    const int closed = ::close(descriptor) == 0 ? 0 : errno;
    return error != 0 ? error : closed;
}

fs::path folderOf(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

// A link is followed: what it points at is replaced, and the link stays.
fs::path targetOf(const fs::path& file) {
    std::error_code ignored;
    if (!fs::is_symlink(file, ignored)) return file;
    const fs::path target = fs::weakly_canonical(file, ignored);
    return ignored ? file : target;
}

bool isSpecial(const fs::path& file) {
    std::error_code ignored;
    const fs::file_status status = fs::status(file, ignored);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

}  // namespace

void requireWritable(const fs::path& file) {
    std::error_code ignored;
    if (isSpecial(file)) return;
    const fs::path target = targetOf(file);
    const fs::path folder = folderOf(target);
    if (target.filename().empty() || fs::is_directory(target, ignored))
        throw Error("cannot write " + file.string() + ": it is a folder; name a file in it");
    if (!fs::is_directory(folder, ignored))
        throw Error("cannot write " + file.string() + ": there is no folder " + folder.string() + "; create it first");
    if (::access(folder.c_str(), W_OK | X_OK) != 0)
        throw Error("cannot write " + file.string() + ": the folder " + folder.string() +
                    " may not be written to; choose another place");
}

void writeFile(const fs::path& file, std::span<const std::byte> bytes) {
    requireWritable(file);
    if (isSpecial(file)) {
        if (const int error = writeOpened(::open(file.c_str(), O_WRONLY | O_CLOEXEC), bytes); error != 0)
            failToWrite(file, error);
        return;
    }
    const fs::path target = targetOf(file);
    const std::string unfinished =
        (folderOf(target) / ("." + target.filename().string() + "." + std::to_string(getpid()) + ".tmp")).string();
    if (unfinished.size() >= PATH_MAX) failToWrite(file, ENAMETOOLONG);
    std::memcpy(unfinishedFile, unfinished.c_str(), unfinished.size() + 1);
    const SignalHandlers handlers(kEndingSignals, removeUnfinishedAndEnd);
    ::unlink(unfinished.c_str());  // left by a program of the same number that was killed
    const int descriptor = ::open(unfinished.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    int error = writeOpened(descriptor, bytes);
    if (error == 0 && ::rename(unfinished.c_str(), target.c_str()) != 0) error = errno;
    if (error == 0) return;
    if (descriptor >= 0) ::unlink(unfinished.c_str());
    failToWrite(file, error);
}

void writeFile(const fs::path& file, std::string_view text) { writeFile(file, std::as_bytes(std::span(text))); }

}  // namespace cleave
