// Frames are reused, so that a join allocates nothing once the engine is warm.
#pragma once

#include "reasoner/owl/engine.h"

namespace lares::owl {

class Engine::FrameScope {
 public:
  explicit FrameScope(Engine& engine) : engine_(engine) {
    if (engine_.frames_.size() == engine_.frames_in_use_) engine_.frames_.emplace_back();
    frame_ = &engine_.frames_[engine_.frames_in_use_++];
  }
  ~FrameScope() { --engine_.frames_in_use_; }
  FrameScope(const FrameScope&) = delete;
  FrameScope& operator=(const FrameScope&) = delete;

  Frame& frame() const { return *frame_; }

 private:
  Engine& engine_;
  Frame* frame_;
};

}  // namespace lares::owl
