#include "apps/command_line/parallel_pieces.hpp"

#include "analysis/threads.hpp"
#include "apps/command_line/interruption.hpp"

#include <tbb/parallel_for.h>

#include <chrono>
#include <future>
#include <memory>
#include <mutex>
#include <thread>

namespace swirl::apps {

namespace {

using std::chrono::milliseconds;

/// What outlives the call, where pieces do.
struct Pieces {
    std::function<KeepResult(std::size_t)> work;
    std::mutex mutex;
    bool kept = true;  ///< results are
    std::size_t finished = 0;
};

void run_piece(Pieces& pieces, std::size_t i, Progress& progress) {
    if (is_interrupted()) return;
    const KeepResult keep = pieces.work(i);
    const std::lock_guard lock(pieces.mutex);
    if (!keep || !pieces.kept) return;
    keep();
    progress.at(static_cast<double>(++pieces.finished));
}

}  // namespace

bool run_pieces(std::size_t count, int threads, Progress& progress,
                const std::function<KeepResult(std::size_t)>& work) {
    if (is_interrupted()) return false;
    const auto pieces = std::make_shared<Pieces>();
    pieces->work = work;
    std::packaged_task<void()> run_all([pieces, count, threads, &progress] {
        analysis::on_threads(threads, [&] {
            tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) { run_piece(*pieces, i, progress); });
        });
    });
    std::future<void> ended = run_all.get_future();
    std::thread runner(std::move(run_all));
    while (ended.wait_for(milliseconds(10)) != std::future_status::ready) {
        if (!is_interrupted() || ended.wait_for(milliseconds(100)) == std::future_status::ready) continue;
        const std::lock_guard lock(pieces->mutex);
        pieces->kept = false;
        runner.detach();
        return false;
    }
    runner.join();
    ended.get();
    return pieces->finished == count;
}

}  // namespace swirl::apps
