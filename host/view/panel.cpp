#include "view/panel.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <filesystem>
#include <utility>

#include "base/text.h"
#include "facade/host_builders.h"

namespace cleave {
namespace {

constexpr float kWidth = 348.0f;
constexpr const char* kKeys[][2] = {{"left drag", "orbit about the pivot"},
                                    {"right or middle drag", "pan"},
                                    {"wheel", "zoom"},
                                    {"W A S D, Q E", "fly, down and up; with shift faster"},
                                    {"double click", "make the point there the pivot"},
                                    {"F", "frame the scene"},
                                    {"1 to 9", "cameras of the scene"},
                                    {"C", "copy the picture's `cleave render` command"},
                                    {"T", "the tree's cells; [ and ] change the level"},
                                    {"R", "the cells along the ray under the cursor"},
                                    {"X", "our answers beside the reference's"},
                                    {"space", "play or pause"},
                                    {"P", "the panel"},
                                    {"H", "this list"},
                                    {"drop a .glb or .gltf", "open it"}};

// What is 1 where letters have their usual size.
float unit() { return ImGui::GetFontSize() / 14.0f; }

void row(const char* name, const std::string& value) {
    ImGui::TextDisabled("%s", name);
    ImGui::SameLine(128.0f * unit());
    ImGui::TextUnformatted(value.c_str());
}

template <class Value, size_t n>
void combo(const char* label, Value& value, const std::array<std::pair<const char*, Value>, n>& table) {
    const char* shown = "";
    for (const auto& [name, known] : table)
        if (known == value) shown = name;
    if (!ImGui::BeginCombo(label, shown)) return;
    for (const auto& [name, known] : table)
        if (ImGui::Selectable(name, known == value)) value = known;
    ImGui::EndCombo();
}

void sceneRows(const Staged& staged) {
    const StagedPose& geometry = *staged.geometry;
    row("scene", oneLine(staged.scene->file.filename().string()));
    row("triangles", grouped(geometry.posed.triangles.size()));
    row("loaded, posed", fixed(staged.scene->loadMs, 1) + " ms, " + fixed(geometry.poseMs, 1) + " ms");
    for (const std::string& warning : staged.warnings) ImGui::TextWrapped("%s", warning.c_str());
}

void builderControls(Controls& controls) {
    StageWish& stage = controls.stage;
    if (ImGui::BeginCombo("builder", std::string(stage.builder.name).c_str())) {
        for (const auto& [name, description] : allBuilders())
            if (ImGui::Selectable(std::string(name).c_str(), stage.builder.name == name)) stage.builder = {name};
        ImGui::EndCombo();
    }
    if (!ImGui::TreeNode("knobs")) return;
    BuildSettings& s = stage.settings;
    static constexpr float kLeast = 1.0f, kMost = 100.0f;
    ImGui::SliderScalar("traverse", ImGuiDataType_Float, &s.costs.traverse, &kLeast, &kMost, "%.0f");
    ImGui::SliderScalar("intersect", ImGuiDataType_Float, &s.costs.intersect, &kLeast, &kMost, "%.0f");
    static constexpr float kBonusLeast = 0.1f, kBonusMost = 1.0f;
    ImGui::SliderScalar("empty bonus", ImGuiDataType_Float, &s.costs.emptyBonus, &kBonusLeast, &kBonusMost, "%.2f");
    static constexpr uint32_t kBinsLeast = 2, kBinsMost = kBins, kNone0 = 0, kExactMost = kMostExactUpTo,
                              kLeafLeast = 1, kLeafMost = 64, kDeepest = kMaxDepth;
    ImGui::SliderScalar("bins", ImGuiDataType_U32, &s.bins, &kBinsLeast, &kBinsMost);
    ImGui::SliderScalar("exact up to", ImGuiDataType_U32, &s.exactUpTo, &kNone0, &kExactMost);
    ImGui::SliderScalar("leaf size", ImGuiDataType_U32, &s.leafSize, &kLeafLeast, &kLeafMost);
    ImGui::SliderScalar("max depth", ImGuiDataType_U32, &s.maxDepth, &kNone0, &kDeepest,
                        s.maxDepth == 0 ? "by count" : "%u");
    ImGui::Checkbox("clip", &s.clip);
    ImGui::SameLine();
    ImGui::Checkbox("snap", &s.snap);
    ImGui::SameLine();
    ImGui::Checkbox("subsample", &s.subsample);
    ImGui::TreePop();
}

void treeRows(const Staged& staged, const StagedTree& built) {
    const TreeStatistics& tree = built.statistics;
    row("build", fixed(built.buildMs, 2) + " ms");
    std::string cost = fixed(tree.sahCost, 1);
    if (staged.exactCost && tree.sahCost && *staged.exactCost > 0.0)
        cost += ", " + fixed(*tree.sahCost / *staged.exactCost, 3) + " of exact";
    row("SAH cost", cost);
    row("nodes, depth", grouped(tree.nodes) + ", " + std::to_string(tree.maxDepth));
    row("references", grouped(tree.references));
    row("peak of build", bytesText(built.peakBytes));
}

void buildRows(const Staged& staged) {
    for (const StagedTree& tree : staged.trees) {
        const bool stays = &tree != &staged.trees.back();
        if (tree.list) row(stays ? "built once" : "built anew", grouped(tree.list->size()) + " triangles");
        treeRows(staged, tree);
    }
    if (staged.passes.empty() || !ImGui::TreeNode("passes of the build")) return;
    double all = 0.0;
    for (const PassWork& pass : staged.passes) all += pass.ms;
    for (const PassWork& pass : staged.passes) {
        if (pass.ms < 0.01 * all) continue;
        ImGui::ProgressBar(static_cast<float>(pass.ms / all), ImVec2(90.0f, 0.0f), fixed(pass.ms, 2).c_str());
        ImGui::SameLine();
        ImGui::TextUnformatted(pass.name.c_str());
    }
    ImGui::TreePop();
}

void traceRows(const Painted& painted) {
    row("picture",
        std::to_string(painted.width) + " x " + std::to_string(painted.height) + ", " + fixed(painted.ms, 1) + " ms");
    if (painted.comparison) {
        const Comparison& c = *painted.comparison;
        row("compared", grouped(c.rays) + " rays");
        row("differ", grouped(c.mismatches) + ", undecided " + grouped(c.undecided));
        return;
    }
    if (painted.mraysPerSecond > 0.0) row("primary rays", fixed(painted.mraysPerSecond, 2) + " M/s");
    if (painted.work)
        row("a ray visits", fixed(painted.work->inner, 0) + " nodes, " + fixed(painted.work->leaves, 0) + " leaves");
    if (painted.work) row("and tests", fixed(painted.work->triangles, 1) + " triangles");
    if (painted.of > 1)
        ImGui::ProgressBar(
            static_cast<float>(painted.samples) / static_cast<float>(painted.of), ImVec2(-1.0f, 0.0f),
            (std::to_string(painted.samples) + " of " + std::to_string(painted.of) + " samples").c_str());
    if (painted.view == View::depth || countsSteps(painted.view))
        row("scale", fixed(double{painted.scaleLow}, 2) + " to " + fixed(double{painted.scaleHigh}, 2));
}

void viewControls(Controls& controls) {
    for (size_t i = 0; i < kViews.size(); ++i) {
        if (i % 3 != 0) ImGui::SameLine(static_cast<float>(i % 3) * 104.0f * unit());
        if (ImGui::RadioButton(kViews[i].first, controls.view == kViews[i].second && !controls.compares)) {
            controls.view = kViews[i].second;
            controls.compares = false;
        }
    }
    ImGui::Checkbox("errors: ours beside the reference", &controls.compares);
    if (!showsSurfaces(controls.view)) return;
    ImGui::SliderFloat("exposure", &controls.exposure, -8.0f, 8.0f, "%+.1f EV");
    static constexpr uint32_t kLeast = 0, kMost = 64;
    if (controls.view == View::path)
        ImGui::SliderScalar("bounces", ImGuiDataType_U32, &controls.bounces, &kLeast, &kMost);
}

void overlayControls(Controls& controls, const Facts& facts) {
    static constexpr uint32_t kLeast = 0, kMost = 16;
    ImGui::SliderScalar("cells to level", ImGuiDataType_U32, &controls.overlayLevel, &kLeast, &kMost,
                        controls.overlayLevel == 0 ? "none" : "%u");
    static constexpr std::array<std::pair<const char*, int>, 4> kAxes = {{{"none", -1}, {"x", 0}, {"y", 1}, {"z", 2}}};
    combo("clip along", controls.clipAxis, kAxes);
    if (controls.clipAxis >= 0) {
        ImGui::SliderFloat("clip at", &controls.clipAt, 0.0f, 1.0f, "%.2f");
        ImGui::SameLine();
        ImGui::Checkbox("above", &controls.clipsAbove);
    }
    ImGui::Checkbox("cells along the ray under the cursor", &controls.rayCells);
    if (!controls.rayCells || facts.leaves.empty()) return;
    constexpr size_t kMostShown = 8;
    if (!ImGui::BeginTable("leaves", 4, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp)) return;
    for (const char* name : {"entry t", "exit t", "depth", "triangles"}) ImGui::TableSetupColumn(name);
    ImGui::TableHeadersRow();
    for (size_t i = 0; i < std::min(kMostShown, facts.leaves.size()); ++i) {
        const PassedLeaf& leaf = facts.leaves[i];
        for (const std::string& text :
             {fixed(leaf.entry, 4), fixed(leaf.exit, 4), std::to_string(leaf.depth), std::to_string(leaf.triangles)}) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(text.c_str());
        }
    }
    ImGui::EndTable();
    if (facts.leaves.size() > kMostShown) ImGui::TextDisabled("and %zu more", facts.leaves.size() - kMostShown);
}

void animationControls(Controls& controls, const Staged& staged) {
    if (staged.scene->animations.empty()) return;
    ImGui::Separator();
    if (ImGui::Button(controls.plays ? "pause" : "play", ImVec2(64.0f * unit(), 0.0f)))
        controls.plays = !controls.plays;
    ImGui::SameLine();
    auto seconds = static_cast<float>(controls.stage.time.value_or(0.0));
    if (ImGui::SliderFloat("##time", &seconds, 0.0f, static_cast<float>(staged.scene->end), "%.2f s"))
        controls.stage.time = double{seconds};
    ImGui::SameLine();
    ImGui::Checkbox("loop", &controls.loops);
    const uint64_t all = staged.geometry->posed.triangles.size(), moving = staged.geometry->movingTriangles;
    row("moving, static", grouped(moving) + ", " + grouped(all - moving));
    row("frame",
        "pose " + fixed(staged.geometry->poseMs, 1) + " ms, build " + fixed(staged.trees.back().buildMs, 1) + " ms");
    if (staged.trees.size() > 1) row("what stays", "built once in " + fixed(staged.trees.front().buildMs, 1) + " ms");
}

void frameRows(const Facts& facts) {
    const std::vector<float> times(facts.frameMs.begin(), facts.frameMs.end());
    if (!times.empty())
        ImGui::PlotLines("##frames", times.data(), static_cast<int>(times.size()), 0, nullptr, 0.0f, 100.0f,
                         ImVec2(-1.0f, 48.0f));
    if (!times.empty())
        row("in motion", fixed(facts.framesPerSecond, 1) + " a second, " + fixed(double{times.back()}, 1) + " ms");
    row("device memory", bytesText(facts.deviceBytes));
    row("device", facts.device);
}

bool drawError(const std::string& error) {
    if (error.empty()) return false;
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(0.5f * size.x, 0.5f * size.y), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    ImGui::SetNextWindowSize(ImVec2(std::min(520.0f, 0.8f * size.x), 0.0f));
    ImGui::PushStyleColor(ImGuiCol_Border, ImVec4(0.9f, 0.3f, 0.25f, 1.0f));
    ImGui::Begin("error", nullptr,
                 ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                     ImGuiWindowFlags_NoSavedSettings);
    ImGui::TextWrapped("%s", error.c_str());
    ImGui::Spacing();
    const bool read = ImGui::Button("close");
    ImGui::End();
    ImGui::PopStyleColor();
    return read;
}

void drawKeys() {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(0.5f * size.x, 0.5f * size.y), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    ImGui::Begin("keys", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings);
    if (ImGui::BeginTable("list", 2, ImGuiTableFlags_SizingFixedFit)) {
        for (const auto& [key, what] : kKeys) {
            ImGui::TableNextColumn();
            ImGui::TextColored(ImVec4(0.55f, 0.80f, 1.0f, 1.0f), "%s  ", key);
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(what);
        }
        ImGui::EndTable();
    }
    ImGui::End();
}

// At the lower right: what goes on beside the picture.
void drawNote(const Facts& facts) {
    const std::string text = !facts.phase.empty() ? facts.phase + " ..." : facts.note;
    if (text.empty()) return;
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(size.x - 12.0f, size.y - 12.0f), ImGuiCond_Always, ImVec2(1.0f, 1.0f));
    ImGui::Begin("note", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::TextUnformatted(text.c_str());
    ImGui::End();
}

}  // namespace

void styleInterface(float scale) {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // nothing is left in the folder where it is run
    constexpr const char* kFont = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
    std::error_code none;
    if (std::filesystem::exists(kFont, none))
        io.Fonts->AddFontFromFileTTF(kFont, 14.0f * scale);
    else
        io.FontGlobalScale = scale;
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = 6.0f;
    style.FrameRounding = style.GrabRounding = 3.0f;
    style.WindowBorderSize = 1.0f;
    style.ItemSpacing = ImVec2(8.0f, 5.0f);
    style.Colors[ImGuiCol_WindowBg] = ImVec4(0.09f, 0.10f, 0.12f, 0.86f);
    style.Colors[ImGuiCol_Border] = ImVec4(1.0f, 1.0f, 1.0f, 0.10f);
    style.ScaleAllSizes(scale);
}

bool drawPanel(Controls& controls, const Facts& facts) {
    drawNote(facts);
    if (controls.keys) drawKeys();
    const bool read = drawError(facts.error);
    if (!controls.panel) return read;
    const float scale = unit();
    ImGui::SetNextWindowPos(ImVec2(12.0f, 12.0f), ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSizeConstraints(ImVec2(kWidth * scale, 0.0f),
                                        ImVec2(kWidth * scale, ImGui::GetIO().DisplaySize.y - 24.0f));
    ImGui::Begin(
        "cleave", nullptr,
        ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PushItemWidth(-108.0f * scale);
    if (facts.staged) sceneRows(*facts.staged);
    if (ImGui::CollapsingHeader("Tree", ImGuiTreeNodeFlags_DefaultOpen)) {
        builderControls(controls);
        if (facts.staged) buildRows(*facts.staged);
    }
    if (ImGui::CollapsingHeader("Rays", ImGuiTreeNodeFlags_DefaultOpen)) {
        combo("traversal", controls.traversal, kTraversals);
        combo("triangle test", controls.test, kTriangleTests);
        if (facts.painted) traceRows(*facts.painted);
    }
    if (ImGui::CollapsingHeader("View", ImGuiTreeNodeFlags_DefaultOpen)) viewControls(controls);
    if (ImGui::CollapsingHeader("Cells")) overlayControls(controls, facts);
    if (facts.staged) animationControls(controls, *facts.staged);
    if (ImGui::CollapsingHeader("Frames", ImGuiTreeNodeFlags_DefaultOpen)) frameRows(facts);
    ImGui::TextDisabled("H lists the keys");
    ImGui::PopItemWidth();
    ImGui::End();
    return read;
}

}  // namespace cleave
