#include "support/picture.h"

namespace cleave::test {

namespace {

const RenderPasses& renderPasses() {
    static std::unique_ptr<RenderPasses> passes;
    if (!passes) {
        passes = std::make_unique<RenderPasses>(device());
        beforeClose([] { passes.reset(); });
    }
    return *passes;
}

template <class T>
Buffer uploaded(const std::vector<T>& items) {
    Buffer b(device(), items.size() * sizeof(T));
    b.upload(std::span<const T>(items));
    return b;
}

}  // namespace

PictureInput::PictureInput(uint32_t pixels, uint32_t seed) {
    const TriangleSet set = mixedSet(100, seed);  // hits are on triangles with an area only
    triangles_ = set.triangles;
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    auto below = [&](uint32_t n) { return static_cast<uint32_t>(random() % n); };
    baseColours_ = {{1.0f, 0.5f, 0.25f, 1.0f}, {0.0f, 0.8f, 0.1f, 1.0f}, {0.3f, 0.3f, 0.3f, 1.0f}};
    for (uint32_t i = 0; i < triangles_.size(); i++) materialOf_.push_back(i % 3);
    for (uint32_t i = 0; i < pixels; i++) {
        Ray r{{unit(random), unit(random), unit(random)}, 0.0f, {unit(random) - 0.5f, unit(random) - 0.5f, 0.7f}, 9.0f};
        rays_.push_back(r);
        const bool found = unit(random) < 0.8f;
        hits_.push_back(found ? Hit{unit(random) * 50.0f,
                                    set.included[below(static_cast<uint32_t>(set.included.size()))], 0.1f, 0.2f}
                              : missedHit());
        shadowHits_.push_back(unit(random) < 0.5f ? hits_.back() : missedHit());
        steps_.push_back({below(60), below(10), below(30), below(5), below(20), below(30)});
    }
    b_[0] = uploaded(rays_);
    b_[1] = uploaded(hits_);
    b_[2] = uploaded(steps_);
    b_[3] = Buffer(device(), pixels * sizeof(Ray));
    b_[4] = uploaded(shadowHits_);
    b_[5] = uploaded(triangles_);
    b_[6] = uploaded(materialOf_);
    b_[7] = uploaded(baseColours_);
    b_[8] = Buffer(device(), pixels * sizeof(uint32_t));
}

twin::ShadeArrays PictureInput::arrays() const {
    return {rays_, hits_, steps_, shadowHits_, triangles_, materialOf_, baseColours_};
}

ShadePush PictureInput::push(uint32_t view) const {
    return {b_[0].address(),
            b_[1].address(),
            b_[2].address(),
            b_[3].address(),
            b_[4].address(),
            b_[5].address(),
            b_[6].address(),
            b_[7].address(),
            b_[8].address(),
            offset,
            low,
            high,
            view,
            static_cast<uint32_t>(rays_.size())};
}

std::vector<Ray> PictureInput::shadowRaysOnDevice() {
    Recorder recorder(device());
    renderPasses().shadowRays(recorder, push(kViewShaded));
    recorder.submit();
    return b_[3].download<Ray>(rays_.size());
}

std::vector<uint32_t> PictureInput::pixelsOnDevice(uint32_t view) {
    Recorder recorder(device());
    renderPasses().shade(recorder, push(view));
    recorder.submit();
    return b_[8].download<uint32_t>(rays_.size());
}

}  // namespace cleave::test
