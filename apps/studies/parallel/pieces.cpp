#include "apps/studies/parallel/pieces.hpp"

#include "analysis/threads.hpp"

#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>

#include <chrono>
#include <future>
#include <memory>
#include <mutex>
#include <thread>

namespace swirl::studies {

namespace {

using std::chrono::milliseconds;

/// What outlives the call, where pieces do.
struct Pieces {
    std::function<KeepResult(std::size_t)> work;
    RunControl control;
    std::mutex mutex;
    bool kept = true;  ///< results are
    std::size_t finished = 0;
};

void run_piece(Pieces& pieces, std::size_t i, const ReportDone& report) {
    if (pieces.control.is_stopped()) return;
    const KeepResult keep = pieces.work(i);
    const std::lock_guard lock(pieces.mutex);
    if (!keep || !pieces.kept) return;
    keep();
    report(static_cast<double>(++pieces.finished));
}

}  // namespace

bool run_pieces(std::size_t count, const std::string& task, const RunControl& control,
                const std::function<KeepResult(std::size_t)>& work) {
    if (control.is_stopped()) return false;
    const ReportDone report =
        task.empty() ? ReportDone([](double) {}) : control.begin(task, static_cast<double>(count));
    const auto pieces = std::make_shared<Pieces>();
    pieces->work = work;
    pieces->control = control;
    std::packaged_task<void()> run_all([pieces, count, &report] {
        analysis::on_threads(pieces->control.threads, [&] {
            const auto run = [&](std::size_t i) { run_piece(*pieces, i, report); };
            tbb::parallel_for(std::size_t{0}, count, run, tbb::simple_partitioner());  // each may be a long one
        });
    });
    std::future<void> ended = run_all.get_future();
    std::thread runner(std::move(run_all));
    while (ended.wait_for(milliseconds(10)) != std::future_status::ready) {
        if (!control.is_stopped() || ended.wait_for(milliseconds(30)) == std::future_status::ready) continue;
        const std::lock_guard lock(pieces->mutex);
        pieces->kept = false;
        runner.detach();
        return false;
    }
    runner.join();
    ended.get();
    return pieces->finished == count;
}

}  // namespace swirl::studies
