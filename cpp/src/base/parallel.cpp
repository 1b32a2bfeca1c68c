#include "base/parallel.hpp"

#if defined(__unix__) || defined(__APPLE__)
#include <pthread.h>
#define VISCOROLL_POSIX
#endif

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>

#include "base/validate.hpp"
#include "viscoroll/cores.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

/// Threads that wait for offers of work. They are started when first needed, and then kept.
class ThreadPool {
 public:
  using Work = std::function<void(std::size_t)>;

  void run(std::size_t helpers, const Work& work, const std::function<void()>& waiting);

#ifdef VISCOROLL_POSIX
  /// End the threads that have no work.
  /// @return the lock; while it is held, no thread is idle
  std::unique_lock<std::mutex> retire();

  void before_fork() { retire().release(); }
  void after_fork_in_parent() { mutex_.unlock(); }
  void after_fork_in_child();
#endif

 private:
  /// Work that a caller offers to helpers. It lives on the caller's stack.
  struct SharedWork {
    const Work& work;
    std::size_t seats;        // number of helpers that may still join
    std::size_t number = 1;   // number of the next helper
    std::size_t working = 0;  // helpers at work
    std::condition_variable ended;
  };

  void grow(std::size_t helpers);
  void help(std::list<std::thread>::iterator self);

  std::mutex mutex_;  // protects all members and all offers
  std::condition_variable offered_;
  std::condition_variable thread_ended_;
  std::deque<SharedWork*> offers_;  // offers with a free seat, the oldest first
  std::list<std::thread> threads_;
  std::list<std::thread> ended_;
  std::size_t idle_ = 0;  // threads that wait for offers
  bool retiring_ = false;
};

void ThreadPool::run(std::size_t helpers, const Work& work, const std::function<void()>& waiting) {
  SharedWork offer{.work = work, .seats = helpers};
  {
    const std::scoped_lock lock(mutex_);
    offers_.push_back(&offer);
    grow(helpers);
  }
  for (std::size_t helper = 0; helper < helpers; ++helper) offered_.notify_one();
  work(0);

  constexpr auto kPeriod = std::chrono::milliseconds(20);
  std::unique_lock lock(mutex_);
  std::erase(offers_, &offer);
  while (!offer.ended.wait_for(lock, kPeriod, [&] { return offer.working == 0; })) {
    lock.unlock();
    waiting();
    lock.lock();
  }
}

/// Start threads for the free seats that exceed the idle threads. The pool has at most one thread for each core except
/// the caller's, or `helpers` threads if that is more.
void ThreadPool::grow(std::size_t helpers) {
  std::size_t seats = 0;
  for (const SharedWork* offer : offers_) seats += offer->seats;
  const std::size_t most = std::max(helpers, static_cast<std::size_t>(core_count() - 1));
  while (!retiring_ && idle_ < seats && threads_.size() < most) {
    const auto self = threads_.emplace(threads_.end());
    try {
      *self = std::thread([this, self] { help(self); });
    } catch (const std::system_error&) {
      threads_.erase(self);
      return;  // The system refuses further threads; the existing ones share the work.
    }
    ++idle_;
  }
}

void ThreadPool::help(std::list<std::thread>::iterator self) {
  std::unique_lock lock(mutex_);
  for (;;) {
    offered_.wait(lock, [&] { return retiring_ || !offers_.empty(); });
    --idle_;
    if (retiring_) break;
    SharedWork& offer = *offers_.front();
    const std::size_t number = offer.number++;
    if (--offer.seats == 0) offers_.pop_front();
    ++offer.working;
    lock.unlock();
    offer.work(number);
    lock.lock();
    if (--offer.working == 0) offer.ended.notify_one();  // under the lock, without which the offer may be gone
    ++idle_;
  }
  ended_.splice(ended_.end(), threads_, self);
  thread_ended_.notify_all();
}

/// The pool of the process. It is never destroyed, because threads may still compute while the process ends.
ThreadPool& the_pool() {
  static ThreadPool& pool = *std::make_unique<ThreadPool>().release();
  return pool;
}

#ifdef VISCOROLL_POSIX
std::unique_lock<std::mutex> ThreadPool::retire() {
  std::unique_lock lock(mutex_);
  while (idle_ > 0) {
    retiring_ = true;
    offered_.notify_all();
    thread_ended_.wait(lock);
  }
  retiring_ = false;
  for (std::thread& thread : ended_) thread.join();  // these threads no longer need the lock
  ended_.clear();
  return lock;
}

/// Construct the pool anew in the child. Of the old members only the offers are destroyed: threads of the parent may
/// wait for its condition variables, and the working threads do not exist in the child, so that their handles cannot be
/// closed.
void ThreadPool::after_fork_in_child() {
  mutex_.unlock();
  std::destroy_at(&offers_);
  std::construct_at(this);
}

/// Handlers that end all idle threads before the process forks and when the library is unloaded.
struct ExitHandlers {
  ExitHandlers() noexcept {
    the_pool();
    pthread_atfork([] { the_pool().before_fork(); }, [] { the_pool().after_fork_in_parent(); },
                   [] { the_pool().after_fork_in_child(); });
  }
  ~ExitHandlers() { the_pool().retire(); }
};

/// The handlers are installed when the library is loaded. If another thread installed them later while the process
/// forks, the child would inherit an unfinished installation and wait for its end permanently.
const ExitHandlers kExitHandlers;
#endif

/// Run `work(0)` on the calling thread and, at the same time, `work(1)`, `work(2)`, ... on helper threads.
///
/// All callers of the process share the helpers. A helper that is busy until `work(0)` has ended does not take part, so
/// that nested calls and calls from several threads cannot wait for one another. When this function returns, all calls
/// of `work` that began have ended.
/// @param[in] helpers largest number of helper threads
/// @param[in] work function that must not throw
/// @param[in] waiting function that is called about every 20 ms while the caller waits for helpers; must not throw
void run_together(std::size_t helpers, const std::function<void(std::size_t)>& work,
                  const std::function<void()>& waiting) {
  the_pool().run(helpers, work, waiting);
}

}  // namespace

void Watch::poll(std::string_view stage, double fraction) {
  constexpr auto period = std::chrono::milliseconds(20);
  const auto now = Clock::now();
  if (now - last_ < period) return;
  last_ = now;
  if (observer_.progress) observer_.progress({.stage = stage, .fraction = fraction});
  if (observer_.cancelled && observer_.cancelled()) throw Canceled();
}

std::unique_lock<std::timed_mutex> lock_watched(std::timed_mutex& mutex, Watch& watch, std::string_view stage) {
  using Clock = std::chrono::system_clock;  // the thread sanitizer of GCC 12 does not detect locks by the steady clock
  std::unique_lock lock(mutex, std::defer_lock);
  while (!lock.try_lock_until(Clock::now() + std::chrono::milliseconds(20))) watch.poll(stage, 0.0);
  return lock;
}

void require_thread_count(int threads) {
  if (threads >= 0 && threads <= kMaxThreads) return;
  reject("threads", "in [0, " + std::to_string(kMaxThreads) + "]", std::to_string(threads));
}

std::size_t worker_count(std::size_t count, int threads) {
  const auto wanted = static_cast<std::size_t>(threads > 0 ? threads : core_count());
  return std::clamp<std::size_t>(wanted, 1, std::max<std::size_t>(count, 1));
}

void parallel_for(std::size_t count, int threads, Watch& watch, std::string_view stage,
                  const std::function<void(std::size_t, const Worker&)>& body,
                  const std::function<double()>& fraction) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> stop{false};
  std::exception_ptr failure;
  std::mutex failure_mutex;

  const auto guarded = [&](const auto& action) {
    try {
      action();
    } catch (...) {
      const std::scoped_lock lock(failure_mutex);
      if (!failure) failure = std::current_exception();
      stop = true;  // after the failure is stored, since the checkpoints of the other workers then throw as well
    }
  };
  const auto poll = [&] {
    watch.poll(stage, fraction ? fraction()
                               : static_cast<double>(std::min<std::size_t>(next, count)) / static_cast<double>(count));
  };
  const auto run = [&](std::size_t number) {
    const Worker worker{.number = number, .checkpoint = [&, number] {
                          if (number == 0) poll();
                          if (stop) throw Canceled();
                        }};
    guarded([&] {
      for (std::size_t index = next++; index < count && !stop; index = next++) {
        body(index, worker);
        worker.checkpoint();
      }
    });
  };

  if (const std::size_t workers = worker_count(count, threads); workers > 1) {
    run_together(workers - 1, run, [&] {
      if (!stop) guarded(poll);
    });
  } else {
    run(0);
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace viscoroll::detail
