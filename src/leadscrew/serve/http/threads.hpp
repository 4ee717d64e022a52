#pragma once
// Threads that answer requests: made as they are needed, for each viewer of a machine keeps one.

#include <httplib.h>

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace leadscrew::serve {

class Threads : public httplib::TaskQueue {
 public:
  explicit Threads(std::size_t most) : most_(most) {}
  ~Threads() override { shutdown(); }

  void enqueue(std::function<void()> task) override {
    {
      const std::lock_guard lock(mutex_);
      if (waiting_ <= tasks_.size() && threads_.size() < most_) add_thread();
      if (!threads_.empty()) {
        tasks_.push_back(std::move(task));
        changed_.notify_one();
        return;
      }
    }
    task();  // by the thread that accepts, for there is no other
  }

  /// Waits for tasks to end; those that have not begun are done.
  void shutdown() override {
    {
      const std::lock_guard lock(mutex_);
      ends_ = true;
    }
    changed_.notify_all();
    for (std::thread& thread : threads_) thread.join();
    threads_.clear();
  }

 private:
  /// Where the system gives one.
  void add_thread() {
    try {
      threads_.emplace_back([this] { work(); });
    } catch (const std::system_error&) {
      // those that there are do it
    }
  }

  void work() {
    std::unique_lock lock(mutex_);
    while (true) {
      ++waiting_;
      changed_.wait(lock, [this] { return ends_ || !tasks_.empty(); });
      --waiting_;
      if (tasks_.empty()) return;
      const auto task = std::move(tasks_.front());
      tasks_.pop_front();
      lock.unlock();
      task();
      lock.lock();
    }
  }

  const std::size_t most_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> tasks_;
  std::vector<std::thread> threads_;
  std::size_t waiting_ = 0;  ///< threads without a task
  bool ends_ = false;
};

}  // namespace leadscrew::serve
