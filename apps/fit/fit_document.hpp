// What `swirl fit` writes.
#pragma once

#include "analysis/fits/fit_impacts.hpp"
#include "apps/command_line/documents.hpp"
#include "apps/fit/falls_document.hpp"
#include "apps/fit/film_document.hpp"
#include "apps/record/record_writer.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace swirl::apps::fit {

struct FitReport {
    analysis::ImpactFit fit;
    std::size_t rows = 0, left_out = 0;  ///< of the table
    bool inertia_given = false;
    std::vector<std::string> notes;
    Settings settings;
    std::optional<FilmReport> film;    ///< where the impacts are those of a film in the dish
    std::optional<FallsReport> falls;  ///< where they are those of falls on a plate
};

void write_json(const FitReport& report);
void write_record(const RecordGroup& root, const FitReport& report);
void print_report(const FitReport& report);

}  // namespace swirl::apps::fit
