// What a process of its own says, and what becomes of one that comes down.
#include "acquisition/readers/own_process.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/progress.hpp"
#include "acquisition/readers/named_array.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/support/matchers.hpp"

#include <csignal>

namespace tapfit::acquisition {
namespace {

class OwnProcess : public ::testing::Test {
 protected:
  testing::TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.write("data", "x");

  std::string refusal(const std::function<void(std::FILE*)>& write) {
    return refusal_of([&] {
      in_own_process(
          file_, write, [](std::FILE* in) { (void)receive_arrays(in); });
    });
  }
};

TEST_F(OwnProcess, ArraysComeThroughAsTheyAre) {
  NamedArray numbers{.name = "a", .kind = NamedArray::Kind::Numbers};
  numbers.values = Eigen::MatrixXd::Random(70000, 2);  // more than a pipe holds
  const NamedArray texts{
      .name = "b", .kind = NamedArray::Kind::Text, .texts = {"m/s\u00b2", ""}};
  std::vector<NamedArray> received;
  in_own_process(
      file_,
      [&](std::FILE* out) {
        send_array(numbers, out);
        send_array(texts, out);
      },
      [&](std::FILE* in) { received = receive_arrays(in); });
  ASSERT_EQ(received.size(), 2U);
  EXPECT_EQ(received[0].values, numbers.values);
  EXPECT_EQ(received[1].texts, texts.texts);
  EXPECT_EQ(received[1].kind, NamedArray::Kind::Text);
}

TEST_F(OwnProcess, ARefusalIsThrownHere) {
  const std::string said = refusal([](std::FILE* out) {
    send_array({.name = "a"}, out);
    throw InputError("is odd", "there", "try this");
  });
  EXPECT_THAT(said, HasSubstr("there: is odd (try this)"));
}

TEST_F(OwnProcess, OneThatComesDownIsADamagedFile) {
  for (const int signal : {SIGSEGV, SIGFPE, SIGKILL}) {
    const std::string said = refusal([&](std::FILE* out) {
      send_array({.name = "a"}, out);
      std::raise(signal);
    });
    EXPECT_THAT(said, HasSubstr(file_.string()));
    EXPECT_THAT(said, HasSubstr("is damaged"));
  }
}

// It would take ten seconds, and then be called damaged.
TEST_F(OwnProcess, EndsWhenItIsToStop) {
  std::stop_source stop;
  const auto work = [](std::FILE* out) {
    send_array({.name = "a"}, out);
    std::fflush(out);
    for (volatile bool on = true; on;) {
    }
  };
  const auto read = [&](std::FILE* in) {
    EXPECT_EQ(std::fgetc(in), 1);  // it is at work
    stop.request_stop();
    while (std::fgetc(in) != EOF) {
    }
  };
  EXPECT_THROW(in_own_process(file_, work, read, stop.get_token()), Stopped);
  EXPECT_THROW(
      in_own_process(
          file_, [](std::FILE*) { std::raise(SIGTERM); }, [](std::FILE*) {}),
      Stopped);
}

}  // namespace
}  // namespace tapfit::acquisition
