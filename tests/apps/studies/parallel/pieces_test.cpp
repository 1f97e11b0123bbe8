// Pieces of work in parallel: each once, and none lost to a stop.
#include "apps/studies/parallel/pieces.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace swirl::studies {
namespace {

TEST(RunPieces, EachIsDoneOnceAndReported) {
    std::vector<int> done(50, 0);
    std::vector<double> reported;
    RunControl control;
    control.begin_task = [&](const std::string& task, double total) -> ReportDone {
        EXPECT_EQ(task, "fifty");
        EXPECT_EQ(total, 50);
        return [&reported](double share) { reported.push_back(share); };
    };
    const auto work = [&done](std::size_t i) -> KeepResult { return [&done, i] { ++done[i]; }; };
    EXPECT_TRUE(run_pieces(done.size(), "fifty", control, work));
    EXPECT_EQ(done, std::vector<int>(50, 1));
    ASSERT_EQ(reported.size(), 50U);
    for (std::size_t i = 0; i < reported.size(); ++i) EXPECT_EQ(reported[i], static_cast<double>(i + 1));
}

TEST(RunPieces, AStopIsHeededWhateverAPieceIsAt) {
    struct Shared {
        std::atomic<bool> stopped = false, release = false, left = false;
    };
    const auto shared = std::make_shared<Shared>();
    RunControl control;
    control.stop = [shared] { return shared->stopped.load(); };
    control.threads = 1;
    std::atomic<int> kept = 0;
    const auto work = [shared, &kept](std::size_t) -> KeepResult {
        shared->stopped = true;
        while (!shared->release) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        shared->left = true;
        return [&kept] { ++kept; };
    };
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_FALSE(run_pieces(1, "", control, work));
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), 5);
    EXPECT_FALSE(shared->left);  // the piece was still at work
    shared->release = true;
    while (!shared->left) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_EQ(kept, 0);
}

TEST(RunPieces, WhatAPieceThrowsIsPassedOnAndAPieceWithoutResultLeavesTheWholeUndone) {
    const auto throws = [](std::size_t) -> KeepResult { throw std::invalid_argument("no such piece"); };
    EXPECT_THROW(run_pieces(3, "", {}, throws), std::invalid_argument);
    const auto none = [](std::size_t i) -> KeepResult { return i == 1 ? KeepResult() : KeepResult([] {}); };
    EXPECT_FALSE(run_pieces(3, "", {}, none));
}

}  // namespace
}  // namespace swirl::studies
