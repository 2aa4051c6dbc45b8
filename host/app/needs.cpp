#include "app/needs.h"

#include <algorithm>
#include <array>

#include "core/trace_push.h"
#include "scene/camera.h"

namespace cleave {
namespace {

struct Words {
    const char* key;
    const char* words;
};
constexpr std::array<Words, kNeedCount> kWords = {{
#define CLEAVE_NEED(key, words) {#key, words},
    CLEAVE_NEEDS(CLEAVE_NEED)
#undef CLEAVE_NEED
}};

void leaveOutUnused(Needs& needs, Need need, uint64_t count) {
    if (count > 0) needs.leaveOut(need, count);
}

}  // namespace

const char* keyOf(Need need) { return kWords[static_cast<size_t>(need)].key; }
const char* wordsOf(Need need) { return kWords[static_cast<size_t>(need)].words; }

NeedSet only(Need need) { return NeedSet().set(static_cast<size_t>(need)); }

void Needs::leaveOut(Need need, Reason reason) { found_.insert_or_assign(need, std::move(reason)); }

std::map<Need, Reason> Needs::leftOut() const {
    std::map<Need, Reason> left = found_;
    std::erase_if(left, [this](const auto& entry) { return keeps(entry.first); });
    return left;
}

std::string Needs::line() const {
    std::string line;
    for (const auto& [need, reason] : leftOut())
        line += (line.empty() ? "left out: " : ", ") + std::string(wordsOf(need));
    return line.empty() ? line : line + "\n";
}

void findInScene(Needs& needs, const Scene& scene, const Box& bounds, bool played) {
    if (!played) needs.leaveOut(Need::animation, scene.animations.empty() ? "the scene has none" : "none is played");
    constexpr Need kAxes[] = {Need::xAxis, Need::yAxis, Need::zAxis};
    for (int axis = 0; axis < 3; ++axis)
        if (bounds.lo[axis] == bounds.hi[axis]) needs.leaveOut(kAxes[axis], "the scene is flat");
    leaveOutUnused(needs, Need::unusedMeshes, scene.unusedMeshes);
    leaveOutUnused(needs, Need::unusedBuffers, scene.unusedBuffers);
}

void findInSurfaces(Needs& needs, const SurfaceData& surfaces, View view) {
    const char* why = showsSurfaces(view) ? "no triangle that is shown has any" : "the view shows none";
    if ((surfaces.parts & kPartTextures) == 0) needs.leaveOut(Need::textures, why);
    if ((surfaces.parts & kPartColours) == 0) needs.leaveOut(Need::vertexColours, why);
    if ((surfaces.parts & kPartNormals) == 0) needs.leaveOut(Need::normals, why);
    if (!showsSurfaces(view)) return;  // nor does it look through anything
    if (!surfaces.hasAlpha) needs.leaveOut(Need::alphaTest, "all that is shown is opaque");
    if (!surfaces.singleSided) needs.leaveOut(Need::backFaces, "all that is shown has two sides");
}

void findInBuild(Needs& needs, const TriangleSet& set, uint32_t exactUpTo, bool mayDoWithout) {
    const size_t count = set.triangles.size();
    if (mayDoWithout && count <= kFewTriangles)
        needs.leaveOut(Need::tree, "rays test " + std::to_string(count) + (count == 1 ? " triangle" : " triangles"));
    if (!needs.isLeftOut(Need::tree) && count <= exactUpTo)
        needs.leaveOut(Need::largeNodes, "there are at most " + std::to_string(exactUpTo) + " triangles");
}

void findInTracing(Needs& needs, const TraceMode& mode) {
    if (!mayGoOn(mode)) needs.leaveOut(Need::trails, "no ray goes on in a further dispatch");
}

void findInPicture(Needs& needs, View view, const Emitters& emitters) {
    if (!partsOf(static_cast<uint32_t>(view)).shadows) needs.leaveOut(Need::shadows, "the view has none");
    if (view == View::path && emitters.slots == 0) needs.leaveOut(Need::emitters, "no surface shines");
    if (!countsSteps(view)) needs.leaveOut(Need::stepCounters, "the view shows none");
}

void keepInSurfaces(const Needs& needs, SurfaceData& surfaces) {
    const size_t corners = 3 * surfaces.surfaceOf.size();
    if (needs.keeps(Need::textures)) surfaces.parts |= kPartTextures;
    if (needs.keeps(Need::vertexColours)) {
        surfaces.parts |= kPartColours;
        if (surfaces.colours.empty()) surfaces.colours.assign(corners, vec4(1.0f));
    }
    if (needs.keeps(Need::normals)) {
        surfaces.parts |= kPartNormals;
        if (surfaces.normals.empty()) surfaces.normals.assign(corners, vec3(0.0f));
    }
    surfaces.hasAlpha = surfaces.hasAlpha || needs.keeps(Need::alphaTest);
    surfaces.singleSided = surfaces.singleSided || needs.keeps(Need::backFaces);
}

}  // namespace cleave
