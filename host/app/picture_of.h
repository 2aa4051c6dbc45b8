// A picture of a session's scene as the options ask for it: what render makes of one pose.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "app/interrupt.h"
#include "app/session.h"
#include "base/stopwatch.h"

namespace cleave {

// What a picture is of.
struct PictureSubject {
    const Scene& scene;
    const PosedScene& posed;  // of its triangles only what the view shows
    const Box& restBounds;
    Needs& needs;
};

// Throws NotFound if the scene does not have the camera that is asked for.
PictureRequest requestOf(Run& run, const PictureSubject& subject);
PictureRequest requestOf(Run& run, Session& session);

// Says after each sample how far a picture is, and whether it goes on: --time-limit and, where the picture is all that
// there is to do, Ctrl-C end it with the samples that it has.
class SampleWatch {
  public:
    SampleWatch(Run& run, uint32_t samples, const Interrupt* interrupt)
        : run_(run), samples_(samples), interrupt_(interrupt) {}

    bool goesOn(uint32_t taken);
    bool wasInterrupted() const { return interrupt_ && interrupt_->happened() && !timedOut_; }

  private:
    Run& run_;
    uint32_t samples_;
    const Interrupt* interrupt_;
    Stopwatch watch_;
    bool timedOut_ = false;
};

// What the file is to hold: a PNG of the pixels or, by its name, an EXR of the radiance that the renderer has.
std::vector<std::byte> bytesOf(const std::filesystem::path& file, const Picture& picture, const Renderer& renderer);

// Judges rays of the picture that was rendered last.
CheckResult checkPicture(Run& run, Session& session, const Forest& forest, const DeviceSurfaces& surfaces,
                         const PictureRequest& request);

}  // namespace cleave
