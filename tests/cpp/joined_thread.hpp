/// @file
/// @brief Replacement of std::jthread, which the standard library of Apple's Clang does not provide.
#pragma once

#include <functional>
#include <thread>
#include <utility>

namespace viscoroll::detail {

class JoinedThread {
 public:
  explicit JoinedThread(std::function<void()> work) : thread_(std::move(work)) {}
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
