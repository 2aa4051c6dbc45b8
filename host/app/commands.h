// The commands, one file each. They throw Error for what fails; NotFound, one of these, is wrong use that shows late.
#pragma once

#include "app/run.h"

namespace cleave {

void runRender(Run& run);
void runFrames(Run& run);  // render --frames
void runTrace(Run& run);
void runQuery(Run& run);
void runInfo(Run& run);
void runBench(Run& run);
void runQueryBench(Run& run);  // bench --queries
void runSurvey(Run& run);      // bench --survey
void runNeedsBench(Run& run);  // bench --needs
void runReport(Run& run);
void runStability(Run& run);
void runParity(Run& run);  // of stability --parity
void runLeaks(Run& run);   // of stability --leaks
void runDevices(Run& run);

}  // namespace cleave
