#include "tui/options/option_groups.hpp"

namespace tapfit::tui {

void add_together_options(CLI::App& command, CommandOptions& options) {
  TogetherArguments& together = options.together;
  command.add_option("BUNDLES", together.bundles, "Two tests or more")
      ->required()
      ->expected(2, 1000);
  command.add_flag("--inside",
                   options.inside,
                   "Refuse a test that reads from outside its folder");
  command
      .add_option("--shared-effect",
                  together.shared,
                  "Effect of one size in all tests, for example "
                  "channel-gain@hammer")
      ->check(CLI::Validator(effect_fault, "EFFECT[@PLACE]"))
      ->allow_extra_args(false);
  command
      .add_option("--effect-in",
                  together.single,
                  "Number of a test, from 1, and an effect that it alone has: "
                  "--effect-in 2 added-mass@201")
      ->type_name("N EFFECT")
      ->allow_extra_args(false);
  command
      .add_option("--own",
                  together.own,
                  "Uncertain property, for example E:1, that each test has for "
                  "itself")
      ->allow_extra_args(false);
  command.add_flag("--several-structures",
                   together.structures,
                   "The tests are of different structures: they share effects "
                   "alone");
}

}  // namespace tapfit::tui
