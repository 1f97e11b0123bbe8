#include "apps/command_line/run_control.hpp"

#include "apps/command_line/interruption.hpp"
#include "apps/command_line/progress.hpp"

#include <memory>
#include <string>

namespace swirl::apps {

RunControl run_control(const OutputOptions& output) {
    const auto begin = [quiet = output.quiet](const std::string& task, double total) -> ReportDone {
        const auto progress = std::make_shared<Progress>(task, total, quiet);
        return [progress](double done) { progress->at(done); };
    };
    return {interruption(), output.threads, begin};
}

}  // namespace swirl::apps
