#include <new>
#include <string>

#include "app/commands.h"
#include "app/frame_files.h"
#include "app/picture_of.h"
#include "app/report.h"
#include "app/scene_trees.h"
#include "base/error.h"
#include "base/text.h"
#include "figures/legend.h"
#include "formats/write_file.h"

namespace cleave {
namespace {

namespace fs = std::filesystem;

struct Frame {
    uint64_t number = 0;
    double seconds = 0.0;
    fs::path file;
};

// A picture gets its name when it is whole. An empty file of that name is none.
bool isFinished(const Frame& frame) {
    std::error_code failed;
    const auto size = fs::file_size(frame.file, failed);
    return !failed && size > 0;
}

// A scene whose frames are rendered. What was opened, compiled and read for one of them serves all.
class FrameRenderer {
  public:
    explicit FrameRenderer(Run& run)
        : run_(run),
          session_(run, run.options.scenes.empty() ? defaultScene() : run.options.scenes.front(),
                   showsSurfaces(run.options.view) ? Detail::corners : Detail::triangles),
          surfaces_(session_.surfacesOnDevice(run.options.view)),
          trees_(run.options, session_,
                 {countsSteps(run.options.view), run.options.frames->first < run.options.frames->last,
                  raysOf(run.options)}) {
        // No other builder has what the device poses.
        if (run.options.devicePose != Choice::off && trees_.builder() == Builder::gpu)
            session_.mayPoseOnDevice(run.options.devicePose == Choice::on);
        requestOf(run, session_);  // a camera that is not there shows now
        report_["scene"] = sceneJson(session_);
        report_["frames"] = Json::array();
    }

    // Poses, builds, renders and writes. The file appears last of all: where it is, nothing has failed.
    void render(const Frame& frame) {
        const Options& options = run_.options;
        session_.poseAt(frame.seconds);
        session_.moveSurfaces(surfaces_);
        trees_.build(true);
        const PictureRequest request = requestOf(run_, session_);
        const Forest forest = trees_.forest(request.camera.eye);
        const Picture picture = pictureOf(forest, request);
        const std::vector<std::byte> bytes = bytesOf(frame.file, picture, run_.device.renderer());
        Json figures = figuresOf(frame, picture);
        CheckResult check;
        if (options.check > 0) {
            check = checkPicture(run_, session_, forest, surfaces_, request);
            figures["check"] = checkJson(check);
            checked_.add(check);
        }
        requireAnswered(picture.cappedRays, check, session_.scene().name);
        writeFile(frame.file, bytes);
        report_["frames"].push_back(std::move(figures));
        if (rendered() == 1) staticMs_ = trees_.staticMs();
        buildMs_ += movingMs();
        traceMs_ += picture.traceMs;
    }

    uint64_t rendered() const { return report_["frames"].size(); }

    // Of what was rendered so far.
    Json report() const {
        Json report = report_;
        report["build"] = {{"builder", nameOf(trees_.builder())},
                           {"trees", trees_.areSplit() ? 2 : 1},
                           {"staticMs", numberJson(staticMs_)},
                           {"setupMs", numberJson(run_.device.setupMilliseconds())}};
        if (run_.options.check > 0) report["check"] = checkJson(checked_);
        return report;
    }
    std::string summary() const {
        const auto count = static_cast<double>(rendered());
        return session_.needs().line() + "motion    " + grouped(trees_.movingTriangles()) + " of " +
               grouped(trees_.movingTriangles() + trees_.staticTriangles()) + " triangles move" + animationsText() +
               "\n" +
               (trees_.areSplit() ? "once      build " + fixed(staticMs_, 3) + " ms, what does not move\n" : "") +
               (rendered() > 0 ? "each      build " + fixed(buildMs_ / count, 3) + " ms, trace " +
                                     fixed(traceMs_ / count, 3) + " ms\n"
                               : "") +
               (run_.options.check > 0 ? checkedLine(checked_) : "");
    }

  private:
    double movingMs() const { return trees_.ms() - trees_.staticMs(); }

    Picture pictureOf(const Forest& forest, PictureRequest request) {
        run_.progress.phase("rendering");
        SampleWatch watch(run_, request.samples, nullptr);
        request.goesOn = [&](uint32_t taken) { return watch.goesOn(taken); };
        Picture picture = run_.device.renderer().render(forest, session_.trianglesOnDevice(), surfaces_, request);
        run_.progress.clear();
        if (request.view == View::steps || request.view == View::leaves) drawLegend(picture);
        return picture;
    }

    Json figuresOf(const Frame& frame, const Picture& picture) const {
        return {{"frame", frame.number},
                {"seconds", numberJson(frame.seconds)},
                {"file", frame.file.string()},
                {"posedBy", session_.isPosedOnDevice() ? "device" : "host"},
                {"poseMs", numberJson(session_.poseMilliseconds())},
                {"uploadMs", numberJson(session_.uploadMilliseconds())},
                {"buildMs", numberJson(movingMs())},
                {"traceMs", numberJson(picture.traceMs)},
                {"renderMs", numberJson(picture.ms)},
                {"samples", picture.samples},
                {"staticTriangles", trees_.staticTriangles()},
                {"movingTriangles", trees_.movingTriangles()}};
    }

    std::string animationsText() const {
        const std::vector<uint32_t>& played = session_.animations();
        if (played.empty()) return ": there is no animation";
        if (played.size() > 1) return " in " + std::to_string(played.size()) + " animations";
        return " in animation " + std::to_string(played.front()) + " '" +
               oneLine(session_.scene().animations[played.front()].name) + "'";
    }

    Run& run_;
    Session session_;
    DeviceSurfaces surfaces_;
    SceneTrees trees_;
    double staticMs_ = 0.0;                 // of what is built once
    double buildMs_ = 0.0, traceMs_ = 0.0;  // of all frames
    CheckResult checked_;
    Json report_;
};

// The frames of a part, one after the other.
class FrameLoop {
  public:
    explicit FrameLoop(Run& run)
        : run_(run), range_(*run.options.frames), first_(range_.first + range_.part), renderer_(run) {}

    // Ends early where a frame fails or at Ctrl-C, once the frame is done; `trouble` then says so.
    void run() {
        const Interrupt interrupt;
        for (uint64_t number = first_; number <= range_.last && trouble_.empty(); number += range_.parts) {
            const Frame frame{number, static_cast<double>(number) / range_.fps, frameFile(run_.options.output, number)};
            if (range_.skipExisting && isFinished(frame))
                ++skipped_;
            else
                render(frame);
            if (trouble_.empty() && interrupt.happened() && number + range_.parts <= range_.last)
                trouble_ = "interrupted after frame " + std::to_string(number) + "; " + doneText();
        }
        run_.progress.within("");
    }

    const std::string& trouble() const { return trouble_; }
    Json report() const {
        Json report = renderer_.report();
        report["skippedFrames"] = skipped_;
        return report;
    }
    std::string summary() const {
        const uint64_t count = frames();
        std::string text = renderer_.summary() + "frames    " + grouped(renderer_.rendered()) + " rendered" +
                           (skipped_ > 0 ? ", " + grouped(skipped_) + " were there" : "");
        if (count > 0) text += ": " + frameFile(run_.options.output, first_).string();
        if (count > 1) text += " to " + frameFile(run_.options.output, first_ + (count - 1) * range_.parts).string();
        return text + "\n";
    }

  private:
    uint64_t frames() const { return first_ > range_.last ? 0 : (range_.last - first_) / range_.parts + 1; }
    std::string doneText() const {
        return grouped(renderer_.rendered() + skipped_) + " of " + grouped(frames()) +
               " frames are done, and --skip-existing goes on from there";
    }

    void render(const Frame& frame) try {
        const uint64_t done = renderer_.rendered();
        std::string whole = "frame " + std::to_string(frame.number) + ", " + std::to_string(done + skipped_ + 1) +
                            " of " + std::to_string(frames());
        if (done > 0) {
            const double each = watch_.milliseconds() / 1000.0 / static_cast<double>(done);
            whole += ", " + fixed(each * static_cast<double>(frames() - skipped_ - done), 0) + " s left";
        }
        run_.progress.within(whole);
        renderer_.render(frame);
    } catch (const std::bad_alloc&) {
        failed(frame, "there is not enough memory");
    } catch (const std::exception& error) {
        failed(frame, error.what());
    }

    void failed(const Frame& frame, const std::string& why) {
        run_.progress.clear();
        trouble_ = "frame " + std::to_string(frame.number) + ", at " + fixed(frame.seconds, 3) + " s, failed: " + why +
                   "; " + doneText();
    }

    Run& run_;
    const FrameRange& range_;
    uint64_t first_;
    FrameRenderer renderer_;
    Stopwatch watch_;
    uint64_t skipped_ = 0;
    std::string trouble_;
};

}  // namespace

void runFrames(Run& run) {
    const Options& options = run.options;
    requireWritable(frameFile(options.output, options.frames->first + options.frames->part));
    if (options.json) requireWritable(*options.json);
    FrameLoop loop(run);
    loop.run();
    writeReport(run, loop.report());
    run.print(loop.summary());
    if (!loop.trouble().empty()) throw Error(loop.trouble());
}

}  // namespace cleave
