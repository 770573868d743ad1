// The second thread: it owns the workbench, does one job at a time, reports
// where it is, and hands results over, so that the keyboard never waits.
#pragma once

#include "tui/workbench/snapshot.hpp"
#include "tui/workbench/workbench.hpp"
#include "updating/fit/live_fit.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace tapfit::tui {

/// One piece of work. It changes the snapshot it is given, which then is
/// handed over, and returns what to tell the user, if anything; what it throws
/// ends it and is told.
struct Job {
  std::string title;
  std::function<std::string(Workbench&, Snapshot&, const Progress&)> run;
  std::optional<Need> need;  ///< the result it makes, if that is all it does
};

/// How a job ended, and what is known now.
struct Finished {
  enum class How { Done, Failed, Stopped };
  How how = How::Done;
  std::string title;
  std::string message;  ///< what the job returned or threw
  std::optional<Need> need;
  Snapshot snapshot;
};

struct WorkerStatus {
  bool busy = false;
  std::string title;
  std::string stage;  ///< as the work reports it
  double fraction = 0.0;
  std::vector<std::string> done;  ///< stages that were reported before
  std::chrono::steady_clock::time_point since{};  ///< when the job began
  std::vector<double> errors;  ///< of the fit that runs, step by step
  std::shared_ptr<const updating::LiveFit> live = {};  ///< after the last step
  /// Of a diagnosis: what it has tried so far; no verdict.
  std::shared_ptr<const updating::Diagnosis> tried = {};
  /// When what the share is of was begun, and how far it was then: stages that
  /// go on from each other's share are one piece of work.
  std::chrono::steady_clock::time_point part_since{};
  double part_from = 0.0;
  bool in_parts = false;  ///< one came before this one
};

/// Seconds until that part ends, if it goes on as fast as so far; empty while
/// it has hardly begun.
[[nodiscard]] std::optional<double> part_left_s(
    const WorkerStatus& status, std::chrono::steady_clock::time_point now);

class Worker {
 public:
  explicit Worker(std::unique_ptr<Workbench> bench);
  /// Stops the running job and waits until it has let go.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// @pre not busy, and the last job's end has been taken
  void start(Job job);
  /// Asks the running job to stop; its end is still told.
  void stop();
  /// Asks a running fit to end with what it has reached.
  void keep();
  [[nodiscard]] WorkerStatus status() const;
  /// The end of a job, once.
  [[nodiscard]] std::optional<Finished> take_finished();

 private:
  void loop(const std::stop_token& leave);
  void run(Job& job);
  /// What there is to tell of runs that turned out to be unreadable.
  std::string note_left_out();
  void report(std::string_view stage, double fraction);

  std::unique_ptr<Workbench> bench_;
  Snapshot known_;  ///< the worker thread's own

  mutable std::mutex mutex_;
  std::condition_variable_any wake_;
  std::optional<Job> next_;
  std::optional<Finished> finished_;
  WorkerStatus status_;
  std::stop_source stop_;
  std::atomic<bool> keep_ = false;
  std::jthread thread_;  // last: it uses all of the above
};

/// The job that makes a result. Stages to its left are made on the way, each
/// with its own progress.
[[nodiscard]] Job make(const Need& need);

}  // namespace tapfit::tui
