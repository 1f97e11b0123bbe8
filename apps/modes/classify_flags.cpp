#include "apps/modes/classify_flags.hpp"

namespace swirl::apps {

void add_classify_flags(Flags& command, analysis::ClassifyOptions& settings) {
    add_tail_flags(command, settings,
                   {"impacts before the tail, at most (default 10000)",
                    "impacts of the tail, at most; 64 or more (default 10000)", 100'000'000});
    command
        .add_option("--threshold", settings.recurrence_threshold, "D", "delta of the recurrence rate (default 1e-6)")
        ->check(finite_number_from(0));
}

}  // namespace swirl::apps
