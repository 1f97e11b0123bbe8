#include "apps/python/command_run.hpp"

#include "apps/command_line/caller.hpp"
#include "apps/command_line/errors.hpp"
#include "apps/command_line/program.hpp"
#include "apps/command_line/run_or_fail.hpp"
#include "apps/commands.hpp"
#include "apps/python/background.hpp"
#include "apps/record/hdf5_threads.hpp"

#include <memory>
#include <mutex>

namespace swirl::python {

namespace {

/// One run, which outlives the call where its command is left to end by itself.
struct Run {
    std::vector<std::string> words;
    std::shared_ptr<apps::Caller> caller = std::make_shared<apps::Caller>();
    int code = apps::exit_interrupted;
    std::string failure;
};

int run_words(std::vector<std::string>& words) {
    apps::Program program("", "", "");
    apps::add_commands(program);
    std::string name = "swirl";
    std::vector<char*> arguments = {name.data()};
    for (std::string& itinerary : words) arguments.push_back(itinerary.data());
    return program.called(static_cast<int>(arguments.size()), arguments.data())();
}

void run(Run& run) {
    // Records are written and read by one thread at a time where the HDF5 library wants that.
    static std::mutex one_at_a_time;
    std::unique_lock alone(one_at_a_time, std::defer_lock);
    if (!apps::hdf5_is_safe_in_threads()) alone.lock();
    const apps::RunFor run_for(run.caller);
    run.code = apps::run_or_fail([&] { return run_words(run.words); },
                                 [&](const apps::Failure& failure) { run.failure = failure.line; });
}

}  // namespace

CommandResult run_command(const std::vector<std::string>& words, const Look& look) {
    const auto shared = std::make_shared<Run>();
    shared->words = words;
    const auto caller = shared->caller;
    Watch watch;
    watch.look = [&] {
        if (const auto task = caller->task(); task && look) look(task->name, task->total, task->done);
    };
    watch.stop = [&] { caller->stop(); };
    watch.is_finishing = [&] { return caller->is_finishing(); };
    const Background background = run_beside([shared] { run(*shared); }, watch);
    CommandResult result;
    result.raised = background.raised;
    result.code = apps::exit_interrupted;
    if (!background.is_over) return result;
    result.code = shared->code;
    result.text = caller->take_out_text();
    result.messages = caller->messages();
    result.failure = shared->failure;
    return result;
}

apps::ProgramDefinition definition() {
    apps::Program program("", "", "");
    apps::add_commands(program);
    return program.definition();
}

}  // namespace swirl::python
