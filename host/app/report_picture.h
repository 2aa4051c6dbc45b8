// What a picture leaves beside its file: a report and a few lines.
#pragma once

#include <string>

#include "app/run.h"
#include "figures/json.h"
#include "run/renderer.h"

namespace cleave {

struct FinishedPicture {
    std::string sceneName;
    Json scene;          // as sceneJson() has it
    Json build;          // of the trees
    std::string before;  // the lines that come first
    PictureRequest request;
    Picture picture;
    CheckResult check;  // where the run checks
};

// Throws Error if the picture is not to be trusted; by then it is reported all the same.
void reportPicture(Run& run, FinishedPicture finished);

}  // namespace cleave
