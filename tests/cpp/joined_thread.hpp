/// @file
/// @brief std::jthread, which the standard library of Apple's Clang keeps from programs.
#pragma once

#include <thread>
#include <utility>

namespace viscoroll::detail {

class JoinedThread {
 public:
  template <class Work>
  explicit JoinedThread(Work&& work) : thread_(std::forward<Work>(work)) {}
  ~JoinedThread() {
    if (thread_.joinable()) thread_.join();
  }
  JoinedThread(JoinedThread&&) noexcept = default;
  JoinedThread& operator=(JoinedThread&&) = delete;
  JoinedThread(const JoinedThread&) = delete;
  JoinedThread& operator=(const JoinedThread&) = delete;

 private:
  std::thread thread_;
};

}  // namespace viscoroll::detail
