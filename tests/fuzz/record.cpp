// What a record holds and states of itself, by four ways: a good file of HDF5 with whatever in it to every reader of
// records; the head of a file; a journal that was damaged.
#include "apps/boundaries/read_planes.hpp"
#include "apps/classify/classify_record.hpp"
#include "apps/input/input_options.hpp"
#include "apps/orbits/recorded_cycles.hpp"
#include "apps/record/journal.hpp"
#include "apps/record/record_checksum.hpp"
#include "apps/record/record_reader.hpp"
#include "apps/studies/certify/certified_orbit.hpp"
#include "apps/sweep/shard.hpp"
#include "tests/fuzz/bytes.hpp"
#include "tests/fuzz/made_record.hpp"
#include "tests/fuzz/memory_file.hpp"
#include "tests/fuzz/outcome.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace swirl::apps {
namespace {

using tests::fuzz::answers, tests::fuzz::Bytes, tests::fuzz::MemoryFile, tests::fuzz::require;

bool read_as_orbit(const std::string& file) {
    return answers([&] {
        const OrbitColumns orbit = read_orbit(file, {1, 2}, {"S", "t"});
        require(orbit.values.size() == 2 && orbit.values[0].size() == 2, "the impacts that were asked for");
        SceneOptions scene;
        StartOptions start;
        set_from_record(orbit, scene, start);
        start.start<double>(scene.scene<double>());
    });
}

bool read_for_a_verdict(const std::string& file) {
    SceneOptions scene;
    StartOptions start;
    return answers([&] {
        const auto orbit = classify::recorded_orbit(file, std::nullopt, std::nullopt, scene, start);
        require(orbit.first >= 0 && orbit.collisions >= 1, "a verdict needs impacts");
    });
}

bool read_as_series(const std::string& file) {
    bool is_one = false;
    return answers([&] {
               is_one = is_series_record(file);
               if (!is_one) return;
               const MeasuredSeries series = read_series_record(file);
               require(series.times.size() == series.values.size() && series.values.size() >= 2,
                       "as many times as values");
               require(std::is_sorted(series.times.begin(), series.times.end()), "times do not fall");
           }) &&
           is_one;
}

bool read_as_cycles(const std::string& file) {
    return answers([&] {
        for (const auto& place : orbits::cycles_of_record(file).places) certify::candidate_at(place);
    });
}

bool read_as_starting_points(const std::string& file) {
    const Scene<double> scene{6, 0.4, 0.5, 0.5, 0.9, Law::poisson, 5.0 / 12};
    const auto plane = boundaries::plane_from({"beta=0.3:0.7", "mu=0.3:0.7"});
    return answers([&] { boundaries::starting_points_of_record(file, scene, plane); });
}

bool read_as_shard(const std::string& file) {
    return answers([&] {
        const sweep::ReadShard read = sweep::read_shard_file(file);
        require(1 <= read.shard.number && read.shard.number <= read.shard.of, "a shard is one of its sweep's");
    });
}

void read_made_record(Bytes& bytes) {
    auto items = tests::fuzz::items_of_command(bytes.below(tests::fuzz::reading_commands));
    const bool whole = bytes.empty();
    tests::fuzz::change(items, bytes);
    const MemoryFile file;
    tests::fuzz::write_record(items, file.descriptor(), file.name());
    require(wholeness_of(file.name()) == Wholeness::whole, "a record that was just written is whole");
    const bool is_record = answers([&] { read_everything(RecordReader(file.name())); });
    bool is_read = false;
    for (const auto reader :
         {read_as_orbit, read_for_a_verdict, read_as_series, read_as_cycles, read_as_starting_points, read_as_shard})
        is_read = reader(file.name()) || is_read;
    require(!whole || (is_record && is_read), "what a command writes is read by another");
}

/// Nothing that is damaged may reach HDF5: `whole` is out of reach but for a file that states its own sum.
void read_head(const std::string& content) {
    const MemoryFile file(content);
    bool stated = false;
    answers([&] { stated = wholeness_of(file.name()) != Wholeness::unstated; });
    require(stated == has_checksum(file.name()), "the two ends alone say whether there is a checksum");
}

/// What is replayed are the first entries that were written, unchanged.
void read_journal(Bytes& bytes) {
    const MemoryFile file;
    const std::string header = bytes.text(static_cast<std::size_t>(bytes.below(8)));
    const int damages = bytes.below(4);
    std::vector<std::uint32_t> places;
    for (int i = 0; i < damages; ++i) places.push_back(bytes.take<std::uint32_t>());
    std::vector<std::string> written;
    const auto begin = std::as_bytes(std::span(header));
    {
        Journal journal(file.name(), begin, {});
        while (!bytes.empty() && written.size() < 16) {
            written.push_back(bytes.text(static_cast<std::size_t>(bytes.below(32))));
            journal.append(written.size(), std::as_bytes(std::span(written.back())));
        }
    }
    const auto size = static_cast<std::uint32_t>(std::filesystem::file_size(file.name()));
    for (const std::uint32_t place : places) {
        const char damage = static_cast<char>(place >> 24);
        require(::pwrite(file.descriptor(), &damage, 1, place % size) == 1, "a byte is written");
    }
    std::size_t read = 0;
    answers([&] {
        Journal(file.name(), begin, [&](std::uint64_t index, std::span<const std::byte> payload) {
            require(read < written.size() && index == read + 1, "entries come in their order");
            const auto entry = std::as_bytes(std::span(written[read++]));
            require(std::equal(payload.begin(), payload.end(), entry.begin(), entry.end()), "an entry is unchanged");
        });
    });
    require(damages > 0 || read == written.size(), "all entries come back");
}

}  // namespace
}  // namespace swirl::apps

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace swirl;
    tests::fuzz::Bytes bytes(data, size);
    switch (bytes.below(4)) {
        case 0:
        case 1:
            apps::read_made_record(bytes);
            break;
        case 2:
            apps::read_head(bytes.rest());
            break;
        default:
            apps::read_journal(bytes);
    }
    return 0;
}
