#include "apps/ranks/workers.hpp"

#include "apps/command_line/interruption.hpp"

#include <tbb/task_arena.h>

#include <utility>

namespace swirl::apps {

Workers::Workers(int threads, PieceWork work)
    : threads_(threads > 0 ? threads : tbb::this_task_arena::max_concurrency()), shared_(std::make_shared<Shared>()) {
    shared_->work = std::move(work);
    for (int i = 0; i < threads_; ++i) pool_.emplace_back([shared = shared_] { run(*shared); });
}

Workers::~Workers() {
    {
        const std::lock_guard lock(shared_->mutex);
        shared_->ended = true;
    }
    shared_->changed.notify_all();
    for (std::thread& thread : pool_) is_interrupted() ? thread.detach() : thread.join();
}

void Workers::run(Shared& shared) {
    std::unique_lock lock(shared.mutex);
    while (true) {
        shared.changed.wait(lock, [&] { return shared.ended || !shared.waiting.empty(); });
        if (shared.ended) return;
        const std::size_t piece = shared.waiting.front();
        shared.waiting.pop_front();
        lock.unlock();
        std::optional<std::vector<std::byte>> bytes;
        std::exception_ptr failure;
        try {
            bytes = shared.work(piece);
        } catch (...) {
            failure = std::current_exception();
        }
        lock.lock();
        if (bytes) shared.results.push_back({piece, std::move(*bytes)});
        if (failure) shared.failure = failure;
    }
}

void Workers::add(std::span<const std::size_t> pieces) {
    {
        const std::lock_guard lock(shared_->mutex);
        shared_->waiting.insert(shared_->waiting.end(), pieces.begin(), pieces.end());
    }
    shared_->changed.notify_all();
}

std::size_t Workers::waiting() const {
    const std::lock_guard lock(shared_->mutex);
    return shared_->waiting.size();
}

std::vector<PieceResult> Workers::results() {
    const std::lock_guard lock(shared_->mutex);
    if (shared_->failure) std::rethrow_exception(shared_->failure);
    return std::exchange(shared_->results, {});
}

}  // namespace swirl::apps
