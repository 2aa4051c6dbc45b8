#include "app/picture_of.h"

#include <glm/gtc/constants.hpp>

#include "app/lighting.h"
#include "base/text.h"
#include "formats/exr.h"
#include "formats/png.h"
#include "scene/camera.h"

namespace cleave {
namespace {

// Cameras move with their nodes; what is placed by the scene's bounds stays where the rest pose wants it.
Camera cameraOf(const PictureSubject& subject, const Options& options) {
    const Box& bounds = subject.restBounds;
    ViewOverrides overrides{options.eye, options.look, std::nullopt};
    if (options.fov) overrides.verticalFov = glm::radians(*options.fov);
    return overridden(chooseCamera(subject.posed, bounds, options.camera), bounds, overrides);
}

}  // namespace

PictureRequest requestOf(Run& run, Session& session) {
    const bool showsTriangles = run.options.view == View::path;  // by what they light
    const PosedScene& posed = showsTriangles ? session.posed() : session.posedButTriangles();
    return requestOf(run, {session.scene(), posed, session.restBounds(), session.needs()});
}

PictureRequest requestOf(Run& run, const PictureSubject& subject) {
    const Options& options = run.options;
    PictureRequest request;
    request.camera = imageCamera(cameraOf(subject, options), options.width, options.height, infinity());
    request.view = options.view;
    request.samples = samplesOf(options);
    request.bounces = options.bounces;
    request.exposure = options.exposure;
    request.ambientReach = ambientReachOf(subject.restBounds);
    if (options.view == View::path) request.lighting = lightingOf(subject.scene, subject.posed);
    request.traversal = run.traversal();
    request.test = options.triangleTests.front();
    Needs& needs = subject.needs;
    findInTracing(needs, {Query::closest, request.traversal, request.test, false});
    findInPicture(needs, options.view, request.lighting.emitters);
    request.kept.steps = needs.keeps(Need::stepCounters);
    request.kept.shadows = needs.keeps(Need::shadows);
    request.kept.emitters = needs.keeps(Need::emitters);
    request.kept.trails = needs.keeps(Need::trails);
    return request;
}

bool SampleWatch::goesOn(uint32_t taken) {
    const double seconds = watch_.milliseconds() / 1000.0;
    timedOut_ = run_.options.timeLimit && seconds >= *run_.options.timeLimit;
    const double left = seconds / taken * (samples_ - taken);
    run_.progress.phase("rendering, sample " + std::to_string(taken) + " of " + std::to_string(samples_) + ", " +
                        fixed(left, left < 10.0 ? 1 : 0) + " s left");
    return !timedOut_ && !wasInterrupted();
}

std::vector<std::byte> bytesOf(const std::filesystem::path& file, const Picture& picture, const Renderer& renderer) {
    return file.extension() == ".exr" ? exrOf(picture.width, picture.height, renderer.readRadiance())
                                      : pngOf(picture.width, picture.height, picture.pixels);
}

// The primary rays of a path are gone by the end, and rays that look through something have other hits than the
// reference finds: those through the pixels' centres are judged in their place, by which every triangle is seen.
CheckResult checkPicture(Run& run, Session& session, const Forest& forest, const DeviceSurfaces& surfaces,
                         const PictureRequest& request) {
    Renderer& renderer = run.device.renderer();
    if (showsSurfaces(request.view)) {
        PictureRequest primary = request;
        primary.view = View::normals;
        primary.samples = 1;
        primary.goesOn = nullptr;
        renderer.render(forest, session.trianglesOnDevice(), surfaces, primary);
    }
    return session.check(renderer.readRays(), renderer.readHits(), Query::closest, run.options.check);
}

}  // namespace cleave
