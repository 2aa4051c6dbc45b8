// What the stage builds while an animation plays, and what the painter makes of it.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "view/painter.h"

namespace cleave {
namespace {

using namespace std::chrono_literals;

// The stage and the painter without a window.
class Show {
  public:
    StageWish wish;

    Show() { wish.file = CLEAVE_SOURCE "/scenes/features/animation.glb"; }

    std::shared_ptr<const Staged> staged(double time, bool plays) {
        wish.number++;
        wish.time = time;
        wish.plays = plays;
        stage_.ask(wish);
        while (stage_.handled() < wish.number) std::this_thread::sleep_for(1ms);
        const std::optional<std::string> error = stage_.takeError();
        EXPECT_FALSE(error) << *error;
        return stage_.latest();
    }

    std::vector<uint32_t> painted(const std::shared_ptr<const Staged>& staged, View view = View::shaded) {
        PaintWish paint;
        paint.number = ++paints_;
        paint.staged = staged;
        paint.view = view;
        paint.camera = staged->geometry->posed.cameras.front();
        paint.width = 96;
        paint.height = 64;
        painter_.ask(paint);
        for (;;) {
            const std::shared_ptr<const Painted> picture = painter_.take();
            if (picture && picture->number == paints_ && picture->isDone) return picture->pixels;
            const std::optional<std::string> error = painter_.takeError();
            EXPECT_FALSE(error) << *error;
            if (error) return {};
            std::this_thread::sleep_for(1ms);
        }
    }

  private:
    Stage stage_{"", [] {}};
    Painter painter_{"", [] {}};
    uint64_t paints_ = 0;
};

class OnStage : public testing::Test, public Show {};

TEST_F(OnStage, WhatMovesHasATreeOfItsOwnWhileItPlays) {
    for (const Builder builder : {Builder::exact, Builder::gpu}) {
        wish.builder = builder;
        const auto first = staged(0.25, true);
        ASSERT_EQ(first->trees.size(), 2u);
        EXPECT_EQ(first->trees[0].list->size() + first->trees[1].list->size(), first->geometry->posed.triangles.size());
        EXPECT_EQ(first->trees[1].list->size(), first->geometry->movingTriangles);
        const auto next = staged(0.75, true);
        ASSERT_EQ(next->trees.size(), 2u);
        EXPECT_EQ(next->trees[0].tree, first->trees[0].tree) << "it stays";
        EXPECT_NE(next->trees[1].tree, first->trees[1].tree);
        const std::vector<uint32_t> before = painted(first), playing = painted(next);
        EXPECT_NE(before, playing);
        const auto paused = staged(0.75, false);
        ASSERT_EQ(paused->trees.size(), 1u);
        EXPECT_FALSE(paused->trees[0].list);
        EXPECT_EQ(painted(paused), playing);
        EXPECT_EQ(painted(staged(0.25, false)), before);
    }
}

// What moves is posed and sent alone; a show that begins at a time has posed all of it.
TEST_F(OnStage, WhatStaysIsPosedOnce) {
    for (const char* name : {"animation", "morph_target", "skin"}) {
        wish.file = std::string(CLEAVE_SOURCE "/scenes/features/") + name + ".glb";
        std::vector<std::shared_ptr<const Staged>> staging;
        for (const double time : {0.25, 0.75, 1.1}) staging.push_back(staged(time, true));
        EXPECT_EQ(staging[1]->geometry->still, staging[0]->geometry->still) << name;
        EXPECT_EQ(staging[2]->geometry->still, staging[0]->geometry->still) << name;
        Show another;
        another.wish.file = wish.file;
        const auto alone = another.staged(1.1, false);
        for (const View view : {View::shaded, View::depth}) {
            painted(staging[0], view);
            EXPECT_EQ(painted(staging[2], view), another.painted(alone, view)) << name;
            EXPECT_NE(painted(staging[1], view), another.painted(alone, view)) << name;
        }
    }
}

TEST_F(OnStage, AnotherBuilderBuildsWhatStaysAnew) {
    wish.builder = Builder::exact;
    const auto exact = staged(0.5, true);
    wish.builder = Builder{"spatial-median"};
    const auto median = staged(1.0, true);
    ASSERT_EQ(median->trees.size(), 2u);
    EXPECT_NE(median->trees[0].tree, exact->trees[0].tree);
}

TEST_F(OnStage, WhereNothingMovesThereIsOneTree) {
    wish.file = CLEAVE_SOURCE "/scenes/cornell.glb";
    EXPECT_EQ(staged(0.5, true)->trees.size(), 1u);
}

}  // namespace
}  // namespace cleave
