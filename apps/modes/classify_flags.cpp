#include "apps/modes/classify_flags.hpp"

#include "apps/command_line/number_checks.hpp"

namespace swirl::apps {

void add_classify_flags(Flags& command, analysis::ClassifyOptions& settings) {
    command.add_option("--transient", settings.transient, "impacts before the tail, at most (default 10000)")
        ->type_name("K")
        ->transform(whole_number(0, 1'000'000'000));
    command.add_option("--collisions", settings.collisions, "impacts of the tail, at most; 64 or more (default 10000)")
        ->type_name("K")
        ->transform(whole_number(64, 100'000'000));
    command.add_flag("--exhaustive", settings.exhaustive,
                     "follow every orbit through all of these impacts, whatever its verdict needs");
    command.add_option("--threshold", settings.recurrence_threshold, "delta of the recurrence rate (default 1e-6)")
        ->type_name("D")
        ->check(finite_number_from(0));
}

}  // namespace swirl::apps
