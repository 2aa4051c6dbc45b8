#include "app/measure_paths.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "app/lighting.h"
#include "base/error.h"
#include "base/text.h"
#include "figures/picture_error.h"
#include "formats/base64.h"
#include "formats/png.h"
#include "scene/camera.h"
#include "scene/ray_sets.h"

namespace cleave {
namespace {

struct Plan {
    uint32_t width, height;
    uint32_t fewest, most, reference;  // samples of a pixel; doubled from the fewest to the most
};
constexpr Plan kFull{240, 135, 4, 256, 4096}, kQuick{96, 54, 2, 32, 256};

// The reference is the mean of so many pictures, so that its own error is known, and an interruption costs one of them.
constexpr uint32_t kParts = 8;
// Where samples are few, so many pictures tell their error better than one.
constexpr uint32_t kMostPictures = 8;

std::string textOf(const std::vector<vec3>& radiance) { return base64Of(std::as_bytes(std::span(radiance))); }

std::vector<vec3> radianceOf(const std::string& text, size_t pixels) {
    const std::vector<std::byte> bytes = bytesOfBase64(text);
    std::vector<vec3> radiance(pixels);
    if (bytes.size() != pixels * sizeof(vec3))
        throw Error("the notes of the interrupted report are damaged; remove its unfinished.jsonl and start again");
    std::memcpy(radiance.data(), bytes.data(), bytes.size());
    return radiance;
}

class PathMeasurement {
  public:
    PathMeasurement(Run& run, Session& session, const BuiltTree& built, Notebook& notebook, const std::string& prefix)
        : run_(run),
          session_(session),
          built_(built),
          notebook_(notebook),
          prefix_(prefix),
          plan_(run.options.quick ? kQuick : kFull),
          surfaces_(session.surfacesOnDevice(View::path)) {
        const Box& bounds = session.worldBounds();
        const Camera camera = run.options.interior ? interiorCamera(bounds) : chooseCamera(session.posed(), bounds, "");
        request_.camera = imageCamera(camera, plan_.width, plan_.height, infinity());
        request_.view = View::path;
        request_.bounces = run.options.bounces;
        request_.lighting = lightingOf(session.scene(), session.posed());
        request_.traversal = run.traversal();
    }

    MeasuredPaths all() {
        const MeanPicture reference = meanOfParts(referenceParts());
        if (std::all_of(reference.radiance.begin(), reference.radiance.end(),
                        [](const vec3& c) { return c == vec3(0.0f); }))
            throw Error("no light reaches the camera");
        MeasuredPaths measured;
        measured.errors = {nameOf(built_.builder),  plan_.width, plan_.height, plan_.reference, kParts,
                           100.0 * reference.error, {}};
        const std::vector<uint32_t> referencePixels = shownPixels(reference.radiance);
        addPictures(measured.errors.pictures, reference.radiance, referencePixels);
        measured.shown = {fewestSamples(), {"paths", "reference", encoded(referencePixels)}};
        return measured;
    }

  private:
    Run& run_;
    Session& session_;
    const BuiltTree& built_;
    Notebook& notebook_;
    const std::string prefix_;
    const Plan plan_;
    const DeviceSurfaces surfaces_;
    PictureRequest request_;
    uint32_t nextSeed_ = kParts;  // those before are the reference's
    bool warm_ = false;

    template <class Measure>
    auto once(const std::string& what, Measure measure) {
        return notebook_.once(prefix_ + "paths, " + what, measure);
    }

    size_t pixels() const { return size_t{plan_.width} * plan_.height; }

    Picture render(uint32_t samples, uint32_t seed) {
        request_.samples = samples;
        request_.seed = seed;
        request_.goesOn = [&](uint32_t taken) {
            run_.progress.phase("seed " + std::to_string(seed) + ", sample " + std::to_string(taken) + " of " +
                                std::to_string(samples));
            return true;
        };
        const Picture picture =
            run_.device.renderer().render(*built_.onDevice, session_.trianglesOnDevice(), surfaces_, request_);
        if (picture.cappedRays > 0)
            throw Error(grouped(picture.cappedRays) + " rays were given up at the step cap; please report this scene");
        return picture;
    }

    std::vector<std::vector<vec3>> referenceParts() {
        std::vector<std::vector<vec3>> parts;
        for (uint32_t seed = 0; seed < kParts; ++seed)
            parts.push_back(radianceOf(once("part " + std::to_string(seed) + " of the reference",
                                            [&] {
                                                render(plan_.reference / kParts, seed);
                                                return textOf(run_.device.renderer().readRadiance());
                                            }),
                                       pixels()));
        return parts;
    }

    uint32_t picturesOf(uint32_t samples) const {
        return std::max(run_.options.runs, std::min(kMostPictures, plan_.most / samples));
    }

    // Round by round, there and back, so that what changes as time goes by disturbs all numbers of samples about alike.
    // Times are those of the rounds that all of them take part in.
    void addPictures(std::vector<SampledPictures>& all, const std::vector<vec3>& reference,
                     const std::vector<uint32_t>& referencePixels) {
        for (uint32_t samples = plan_.fewest; samples <= plan_.most; samples *= 2) all.push_back({samples, {}, {}, {}});
        for (uint32_t round = 0; round < picturesOf(plan_.fewest); ++round) {
            for (SampledPictures& pictures : all) {
                const uint32_t seed = nextSeed_++;
                if (round >= picturesOf(pictures.samples)) continue;
                const auto [error, similarity, ms] =
                    once(std::to_string(pictures.samples) + " samples, round " + std::to_string(round),
                         [&] { return picture(pictures.samples, seed, reference, referencePixels); });
                pictures.errors.push_back(error);
                pictures.similarities.push_back(similarity);
                if (round < run_.options.runs) pictures.runs.push_back(ms);
            }
            std::reverse(all.begin(), all.end());
        }
        std::sort(all.begin(), all.end(),
                  [](const SampledPictures& a, const SampledPictures& b) { return a.samples < b.samples; });
    }

    // Its error, its similarity, its milliseconds.
    std::array<double, 3> picture(uint32_t samples, uint32_t seed, const std::vector<vec3>& reference,
                                  const std::vector<uint32_t>& referencePixels) {
        if (!warm_) render(1, seed);
        warm_ = true;
        const Picture made = render(samples, seed);
        const std::vector<vec3> radiance = run_.device.renderer().readRadiance();
        return {100.0 * relativeRmse(radiance, reference),
                structuralSimilarity(shownPixels(radiance), referencePixels, plan_.width, plan_.height), made.ms};
    }

    std::string encoded(const std::vector<uint32_t>& shown) const {
        return base64Of(pngOf(plan_.width, plan_.height, shown));
    }
    // With the seed of the first picture that is measured.
    ReportPicture fewestSamples() {
        return {"paths", std::to_string(plan_.fewest) + " samples",
                once("shown", [&] { return encoded(render(plan_.fewest, kParts).pixels); })};
    }
};

}  // namespace

MeasuredPaths measurePaths(Run& run, Session& session, const BuiltTree& built, Notebook& notebook,
                           const std::string& prefix) {
    return PathMeasurement(run, session, built, notebook, prefix).all();
}

}  // namespace cleave
