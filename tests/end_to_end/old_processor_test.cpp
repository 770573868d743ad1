// On a processor that lacks what the program is built for, one sentence and a
// status take the place of an illegal instruction.
#include "tests/end_to_end/run_program.hpp"
#include "tests/end_to_end/written_files.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

namespace tapfit::end_to_end {
namespace {

// The C library's own view of the processor, which it lets users restrict.
TEST(OldProcessor, IsToldWhatTheProgramIsBuiltFor) {
#ifndef __AVX2__
  GTEST_SKIP() << "built for any processor";
#endif
  const auto said = fresh_folder() / "said";
  for (const char* missing : {"-AVX2", "-FMA", "-BMI2"}) {
    const int status =
        shell_status(fmt::format("GLIBC_TUNABLES=glibc.cpu.hwcaps={} "
                                 "%tapfit --version 2>'{}'",
                                 missing,
                                 said.string()));
    EXPECT_EQ(status, 70) << missing;
    EXPECT_TRUE(holds(read_file(said), "TAPFIT_AVX2=OFF")) << missing;
  }
}

}  // namespace
}  // namespace tapfit::end_to_end
