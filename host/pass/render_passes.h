// The kernels of a picture.
#pragma once

#include "gpu/kernel.h"
#include "gpu/recorder.h"
#include "shared/shade.h"

namespace cleave {

class RenderPasses {
  public:
    explicit RenderPasses(Context& context);
    void shadowRays(Recorder& r, const ShadePush& push) const;
    void shade(Recorder& r, const ShadePush& push) const;

  private:
    Kernel shadowRays_, shade_;
};

}  // namespace cleave
