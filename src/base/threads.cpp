#include "threads.h"

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace roomgen {

namespace {

// A thread that throws would end the program.
class Held {
 public:
  explicit Held(const std::function<void(std::size_t)>& work) : work_(work) {}

  void run(std::size_t thread) {
    try {
      work_(thread);
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!thrown_) thrown_ = std::current_exception();
    }
  }

  void throw_on() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  const std::function<void(std::size_t)>& work_;
  std::mutex mutex_;
  std::exception_ptr thrown_;
};

}  // namespace

void on_threads(std::size_t count, const std::function<void(std::size_t thread)>& work) {
  Held held(work);
  std::vector<std::thread> others;
  others.reserve(count);
  try {
    for (std::size_t i = 1; i < count; ++i) others.emplace_back([&held, i] { held.run(i); });
  } catch (const std::exception&) {  // those that are there do it all
  }
  held.run(0);
  for (auto& other : others) other.join();
  held.throw_on();
}

void share_out(std::size_t tasks, std::size_t threads,
               const std::function<void(std::size_t thread, std::size_t task)>& work) {
  std::atomic<std::size_t> next{0};
  on_threads(threads, [&](std::size_t thread) {
    for (std::size_t task; (task = next++) < tasks;) work(thread, task);
  });
}

}  // namespace roomgen
