#include "acquisition/readers/own_process.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/progress.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <fcntl.h>
#include <memory>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace tapfit::acquisition {
namespace {

constexpr int done = 0;
constexpr int refused = 2;

struct CloseStream {
  void operator()(std::FILE* stream) const { std::fclose(stream); }
};
using Stream = std::unique_ptr<std::FILE, CloseStream>;

// A way for bytes from one process to another.
struct Pipe {
  Stream out_of;
  Stream into;

  explicit Pipe(const std::filesystem::path& file) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) == 0) {
      out_of.reset(::fdopen(ends[0], "rb"));
      into.reset(::fdopen(ends[1], "wb"));
    }
    if (out_of && into) return;
    throw InputError("cannot be read: no process can be had for it",
                     file.string(),
                     "close other programs and try again");
  }
};

// Signals end it as they end any process, and it never computes for longer than
// its file can ask for: a second for each MB, ten besides.
void confine(const std::filesystem::path& file) {
  for (const int signal :
       {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGINT, SIGTERM, SIGPIPE}) {
    std::signal(signal, SIG_DFL);
  }
  std::error_code ignored;
  const std::uintmax_t bytes = std::filesystem::file_size(file, ignored);
  // The C library's last words are no message of this program.
  if (const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
      nowhere >= 0) {
    (void)::dup2(nowhere, STDERR_FILENO);
  }
  const rlim_t seconds = 10 + (ignored ? 0 : bytes >> 20U);
  const rlimit time{seconds, seconds};
  const rlimit none{0, 0};
  (void)::setrlimit(RLIMIT_CPU, &time);
  (void)::setrlimit(RLIMIT_CORE, &none);
}

// A pipe takes 64 kB that nobody reads yet.
void tell(const InputError& error, std::FILE* out) {
  constexpr std::size_t longest = 16000;
  for (const std::string& part :
       {error.fault(), error.where(), error.remedy()}) {
    std::fputs(part.substr(0, longest).c_str(), out);
    std::fputc('\0', out);
  }
}

// Ends without what a program does at its end: that is its parent's business.
[[noreturn]] void work(const Pipe& answer,
                       const Pipe& refusal,
                       const std::filesystem::path& file,
                       const std::function<void(std::FILE*)>& write) {
  confine(file);
  int status = 1;
  try {
    write(answer.into.get());
    status = done;
  } catch (const InputError& error) {
    tell(error, refusal.into.get());
    status = refused;
  } catch (...) {
    status = 1;
  }
  std::fflush(answer.into.get());
  std::fflush(refusal.into.get());
  ::_exit(status);
}

// @throws Stopped where the process was asked to end, as a group may be
int exit_status_of(pid_t process) {
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (signal == SIGINT || signal == SIGTERM) throw Stopped{};
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

std::string text_up_to_zero(std::FILE* in) {
  std::string text;
  for (int c = std::fgetc(in); c > 0; c = std::fgetc(in)) {
    text += static_cast<char>(c);
  }
  return text;
}

}  // namespace

void in_own_process(const std::filesystem::path& file,
                    const std::function<void(std::FILE*)>& write,
                    const std::function<void(std::FILE*)>& read,
                    const std::stop_token& stop) {
  Pipe answer(file);
  Pipe refusal(file);
  const pid_t process = ::fork();
  if (process == 0) work(answer, refusal, file, write);
  answer.into.reset();
  refusal.into.reset();
  if (process > 0) {
    const std::stop_callback end(stop, [&] { ::kill(process, SIGTERM); });
    read(answer.out_of.get());
  }
  answer.out_of.reset();  // what it still writes ends it
  const int status = process > 0 ? exit_status_of(process) : 1;
  if (status == done) return;
  if (status != refused) {
    throw InputError("is damaged: the library that reads it came to no end",
                     file.string(),
                     "copy the file again, or save it anew");
  }
  std::FILE* said = refusal.out_of.get();
  const std::string fault = text_up_to_zero(said);
  const std::string where = text_up_to_zero(said);
  throw InputError(fault, where, text_up_to_zero(said));
}

}  // namespace tapfit::acquisition
