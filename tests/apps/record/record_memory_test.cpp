// Records stream: memory follows the chunk, not the number of rows.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdint>
#include <cstdio>

#include "apps/record/record_reader.hpp"
#include "apps/record/record_writer.hpp"
#include "tests/apps/record/scratch_folder.hpp"
#include "tests/sample_count.hpp"

namespace swirl::tests {
namespace {

long peak_kib() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

double t_of(long row) {
    return 0.25 * static_cast<double>(row);
}

TEST(RecordMemory, TenMillionRowsStreamThrough) {
    const ScratchFolder folder;
    const long rows = sample_count(10'000'000);
    const long warm_up = rows / 100;
    long before = 0;
    apps::RecordWriter writer(folder / "long.h5", {"a long orbit", "0.1.0", "x86-64"});
    const apps::RecordGroup root = writer.root();
    root.dimension("impact", apps::growing);
    auto t = root.column<double>("t", {"impact"}, {"1", "time", {}});
    auto vertex = root.column<std::int32_t>("vertex", {"impact"}, {"1", "vertex", {}});
    auto sticks = root.column<bool>("sticks", {"impact"}, {"1", "sticks", {}});
    for (long row = 0; row < rows; ++row) {
        t.append(t_of(row));
        vertex.append(static_cast<std::int32_t>(row % 6));
        sticks.append(row % 2 == 0);
        if (row == warm_up) before = peak_kib();
    }
    writer.finish();
    const apps::RecordReader reader(folder / "long.h5");
    constexpr long batch = 100'000;
    for (long row = 0; row < rows; row += batch) {
        const auto part = reader.read<double>("/t", {{static_cast<std::uint64_t>(row)}, {batch}});
        ASSERT_EQ(part.front(), t_of(row));
        ASSERT_EQ(part.back(), t_of(row + batch - 1));
    }
    const long growth = peak_kib() - before;
    std::printf("%ld rows: peak memory grew by %ld KiB after the first %ld\n", rows, growth, warm_up);
#ifndef SWIRL_SANITIZED  // sanitizers keep freed memory
    // 130 MB pass through; a batch read back is 0.8 MB, a chunk 0.13 MB, HDF5's own cache of metadata up to 2 MiB.
    EXPECT_LT(growth, 4 * 1024);
#endif
}

}  // namespace
}  // namespace swirl::tests
