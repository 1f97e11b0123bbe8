#include "apps/bifurcate/bifurcate_command.hpp"
#include "apps/studies/diagrams/column_shares.hpp"

#include "apps/modes/escape_document.hpp"
#include "apps/modes/mode_fields.hpp"
#include "apps/modes/risk_document.hpp"
#include "apps/modes/steady_share_table.hpp"
#include "apps/output/wrapped.hpp"
#include "apps/output/write_table.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace swirl::apps::bifurcate {

namespace {

std::string_view itinerary_for(Origin origin) {
    constexpr std::string_view words[] = {"random", "up", "down"};
    return words[static_cast<int>(origin)];
}

/// What one start of a column settled on, or one of its samples.
struct AttractorRow {
    const DiagramColumn* column;
    std::size_t number;  ///< the column's
    const Attractor* attractor;
    const double* state = nullptr;  ///< coordinates of a sample
};

std::vector<AttractorRow> attractors_of(const DiagramColumn& column, std::size_t number) {
    std::vector<AttractorRow> rows;
    for (const auto& attractor : column.attractors) rows.push_back({&column, number, &attractor});
    return rows;
}

/// The samples of attractors, one after the other. A list of them would take more memory than the samples themselves.
class SampleRows {
public:
    class Iterator {
    public:
        Iterator(const AttractorRow* first, const AttractorRow* last) : now_(first), last_(last) { pass_empty(); }
        AttractorRow operator*() const {
            AttractorRow row = *now_;
            row.state = row.attractor->states.col(sample_).data();
            return row;
        }
        Iterator& operator++() {
            if (++sample_ < now_->attractor->states.cols()) return *this;
            sample_ = 0;
            ++now_;
            pass_empty();
            return *this;
        }
        bool operator==(const Iterator& other) const { return now_ == other.now_ && sample_ == other.sample_; }

    private:
        void pass_empty() {
            while (now_ != last_ && now_->attractor->states.cols() == 0) ++now_;
        }

        const AttractorRow* now_;
        const AttractorRow* last_;
        Eigen::Index sample_ = 0;
    };

    explicit SampleRows(std::span<const AttractorRow> attractors) : attractors_(attractors) {}
    Iterator begin() const { return {attractors_.data(), attractors_.data() + attractors_.size()}; }
    Iterator end() const { return {attractors_.data() + attractors_.size(), attractors_.data() + attractors_.size()}; }
    std::size_t size() const {
        std::size_t count = 0;
        for (const AttractorRow& row : attractors_) count += static_cast<std::size_t>(row.attractor->states.cols());
        return count;
    }

private:
    std::span<const AttractorRow> attractors_;
};

void write_samples(JsonWriter& json, const Attractor& attractor, const std::string& observable) {
    const Eigen::MatrixXd& states = attractor.states;
    const Eigen::Index place = states.cols() == 0 ? 0 : place_of(observable, states.rows());
    json.begin_array();
    for (const auto& z : states.colwise()) json.value(z[place]);
    json.end_array();
}

/// What attractors and samples have alike.
std::vector<Field<AttractorRow>> place_fields(const Diagram& diagram) {
    using Row = AttractorRow;
    using F = Field<Row>;
    return {F{"parameter", [](const Row& row) { return row.column->parameter; }, "1", "parameter " + diagram.along.name}
                .record_only(),
            F{"column", &Row::number, "1", "column"}.record_only(),
            F{"origin", [](const Row& row) { return static_cast<std::int64_t>(row.attractor->origin); }, "1",
              "0 random start, 1 followed up, 2 followed down"}
                .json_as([](const Row& row) { return itinerary_for(row.attractor->origin); }),
            {"start", [](const Row& row) { return row.attractor->start; }, "1", "number of the random start"}};
}

/// A table of attractors or samples: the fields that both have, and its own.
Table<AttractorRow> table_of(const std::string& rows, const Diagram& diagram,
                             const std::vector<Field<AttractorRow>>& own, std::vector<std::string> first_in_record) {
    Table<AttractorRow> table{{rows}, place_fields(diagram), std::move(first_in_record)};
    table.fields.insert(table.fields.end(), own.begin(), own.end());
    return table;
}

/// What each orbit settled on, samples or not.
Table<AttractorRow> attractor_table(const BifurcateOptions& options, const Diagram& diagram) {
    using Row = AttractorRow;
    using F = Field<Row>;
    const auto of = [](auto member) { return [member](const Row& row) { return row.attractor->*member; }; };
    const auto errors =
        mean_error_fields<Row>(of(&Attractor::mean_errors), "its standard error along the orbit", "its standard error");
    const auto samples = [](const std::string& name) {
        return [name](JsonWriter& json, const Row& row) { write_samples(json, *row.attractor, name); };
    };
    const auto count = [](const Row& row) { return row.attractor->states.cols(); };
    Table<Row> table =
        table_of("attractor", diagram,
                 {{"outcome", of(&Attractor::outcome), "", "how the orbit ended"},
                  {"mode", of(&Attractor::mode), "", "mode that the start settled on"},
                  kind_field<Row>(of(&Attractor::kind)),
                  period_field<Row>(of(&Attractor::period), "0: none"),
                  {"mean_S", of(&Attractor::mean_spin), "1", "time mean of S"},
                  errors.per_time,
                  {"mean_S_per_impact", of(&Attractor::mean_spin_per_impact), "1", "mean of S over impacts"},
                  errors.per_impact,
                  errors.kind,
                  F{"samples", count, "1", "how many follow in the group samples, in this order"}.record_only(),
                  {"S", samples("S")},
                  F{"values", samples(options.observable)}.when(options.observable != "S")},
                 {"parameter", "mean_S", "column", "start", "origin", "period", "samples", "mode", "kind"});
    const auto driven = driven_fields<Row>(of(&Attractor::growth), of(&Attractor::limit_spin));
    table.fields.insert(table.fields.end() - 2, driven.begin(), driven.end());  // before the samples
    return table;
}

Table<AttractorRow> sample_table(const BifurcateOptions& options, const Diagram& diagram) {
    using F = Field<AttractorRow>;
    const auto coordinate = [](const std::string& name) {  // found once: there are a million rows
        return [of_disk = place_of(name, 4), of_polygon = place_of(name, 5)](const AttractorRow& row) {
            return row.state[row.attractor->states.rows() == 4 ? of_disk : of_polygon];
        };
    };
    const std::string& observable = options.observable;
    return table_of(
        "sample", diagram,
        {{"S", coordinate("S"), "1", "S just after an impact"},
         F{"value", coordinate(observable), units_of_coordinate(observable), observable + " just after an impact"}.when(
             observable != "S")},
        {"parameter", "S", "value", "column", "start"});
}

std::vector<ColumnShare> shares_of(const Diagram& diagram) {
    std::vector<ColumnShare> rows;
    for (std::size_t c = 0; c < diagram.columns.size(); ++c)
        for (const ColumnShare& row : shares_of(diagram.columns[c], c)) rows.push_back(row);
    return rows;
}

struct SteadyRow {
    double parameter;
    std::size_t column;
    const SteadyShare* mode;
};

std::vector<SteadyRow> steady_of(const Diagram& diagram) {
    std::vector<SteadyRow> rows;
    for (std::size_t c = 0; c < diagram.columns.size(); ++c)
        for (const SteadyShare& mode : diagram.columns[c].steady)
            rows.push_back({diagram.columns[c].parameter, c, &mode});
    return rows;
}

Table<SteadyRow> steady_table(const Diagram& diagram) {
    const auto of = [](auto member) { return [member](const SteadyRow& row) { return row.mode->*member; }; };
    return {{"steady_mode"},
            {{"parameter", &SteadyRow::parameter, "1", "parameter " + diagram.along.name},
             {"column", &SteadyRow::column, "1", "column"},
             {"S", of(&SteadyShare::spin), "1", "S of the attracting steady mode"},
             {"share", of(&SteadyShare::share), "1", "share of the random starts that came to it"},
             {"flight_time", of(&SteadyShare::flight_time), "1/omega_s", "from impact to impact"},
             {"multiplier", of(&SteadyShare::multiplier), "1", "its largest |multiplier|"}}};
}

/// The columns, with the attractors of each in JSON.
Table<DiagramColumn> column_table(const BifurcateOptions& options, const Diagram& diagram) {
    using Row = DiagramColumn;
    using F = Field<Row>;
    const auto of_usual = [](auto member) { return [member](const Row& column) { return typical(column).*member; }; };
    const auto samples = [](JsonWriter& json, const Row& column) {
        json.begin_array();
        for (const auto& attractor : column.attractors)
            for (const auto& z : attractor.states.colwise()) json.value(z[z.size() - 1]);
        json.end_array();
    };
    const auto attractors = [table = attractor_table(options, diagram)](JsonWriter& json, const Row& column) {
        write_rows(json, table, attractors_of(column, 0), JsonLayout::line);
    };
    const auto shares = [table = share_table(diagram)](JsonWriter& json, const Row& column) {
        write_rows(json, table, shares_of(column, 0), JsonLayout::line);
    };
    const auto steady = [table = steady_share_table()](JsonWriter& json, const Row& column) {
        write_rows(json, table, column.steady, JsonLayout::line);
    };
    return {{"column"},
            {F{"parameter", &Row::parameter, "1", "parameter " + diagram.along.name},
             {"S", samples},
             F{"mode", of_usual(&Attractor::mode), "", "mode of most starts"},
             period_field<Row>(of_usual(&Attractor::period), "of most starts; 0: none"),
             {"shares", shares},
             {"steady_modes", steady},
             F{"interrupted", [](const Row&) { return true; }, no_column}.json_if(
                 [](const Row& column) { return !column.complete; }),
             {"attractors", attractors}},
            {"parameter", "period"}};
}

Settings agreement_of(const Agreement& agreement) {
    return {{"compared", agreement.compared},
            {"largest_difference_of_S", agreement.largest},
            {"largest_distance_of_orbit", agreement.distance},
            {"without_branch", agreement.without},
            {"in_families", agreement.in_families}};
}

SceneBranches branches_of(const BifurcateOptions& options, const Diagram& diagram) {
    return scene_branches(settings_of(options, diagram.along).scene, diagram.along, options.settings.accuracy);
}

}  // namespace

Settings diagram_settings(const BifurcateOptions& options, const Diagram& diagram) {
    Settings settings{{"along", diagram.along.name},
                      {"range", options.along},
                      {"observable", options.observable},
                      {"starts", options.starts},
                      {"speed", options.start.speed()},
                      {"seed", options.start.seed()},
                      {"transient", options.settings.transient},
                      {"collisions", options.settings.collisions},
                      {"exhaustive", options.settings.exhaustive},
                      {"accuracy", options.output.accuracy_name},
                      {"follow", std::int64_t{options.follow}},
                      {"branches", std::int64_t{options.branches}},
                      {"longest_branch", std::int64_t{options.longest_branch}}};
    add_risk_settings(settings, options.risk, options.error);
    return settings;
}

Settings diagram_scene(const BifurcateOptions& options, const Diagram& diagram) {
    Settings settings;
    for (const auto& item : scene_settings(settings_of(options, diagram.along).scene))
        if (item.first != diagram.along.name &&
            !(item.first == "inertia_factor" && diagram.along.name == "inertia-factor"))
            settings.push_back(item);
    return settings;
}

void write_diagram_document(const BifurcateOptions& options, const Diagram& diagram) {
    print_document([&](JsonWriter& json) {
        write_json(json, "scene", diagram_scene(options, diagram));
        if (const auto units = options.scene.units()) write_json(json, "units", unit_settings(*units));
        json.member("along", diagram.along.name);
        write_json(json, "columns", column_table(options, diagram), diagram.columns);
        write_risk(json, diagram.risk);
        if (options.branches) {
            write_branches(json, branches_of(options, diagram), diagram.branches);
            write_json(json, "agreement", agreement_of(diagram.agreement));
        }
        json.member("outcome", diagram.interrupted ? "interrupted" : "completed");
        write_json(json, "settings", diagram_settings(options, diagram));
    });
}

void write_diagram_record(RecordWriter& record, const BifurcateOptions& options, const Diagram& diagram) {
    const RecordGroup root = record.root();
    write_attributes(root.group("scene"), diagram_scene(options, diagram));
    write_attributes(root.group("settings"), diagram_settings(options, diagram));
    std::vector<AttractorRow> attractors;
    for (std::size_t c = 0; c < diagram.columns.size(); ++c)
        for (const AttractorRow& row : attractors_of(diagram.columns[c], c)) attractors.push_back(row);
    const SampleRows samples(attractors);
    if (!diagram.columns.empty()) write_record(root.group("columns"), column_table(options, diagram), diagram.columns);
    const std::vector<ColumnShare> shares = shares_of(diagram);
    if (!shares.empty()) write_record(root.group("shares"), share_table(diagram), shares);
    const std::vector<SteadyRow> steady = steady_of(diagram);
    if (!steady.empty()) write_record(root.group("steady_modes"), steady_table(diagram), steady);
    if (!attractors.empty()) write_record(root.group("attractors"), attractor_table(options, diagram), attractors);
    if (samples.size() > 0) write_record(root.group("samples"), sample_table(options, diagram), samples);
    if (options.branches) write_branches(root, branches_of(options, diagram), diagram.branches, options.observable);
    write_risk(root, diagram.risk);
    record.finish();
}

void print_diagram(const BifurcateOptions& options, const Diagram& diagram) {
    std::map<std::string, std::int64_t> counts;
    std::vector<JudgedRun> judged;
    for (std::size_t c = 0; c < diagram.columns.size(); ++c)
        for (const auto& attractor : diagram.columns[c].attractors) {
            ++counts[std::string(name_of(attractor.mode))];
            judged.push_back({attractor.kind, attractor.outcome, attractor.impacts, c});
        }
    std::vector<ColumnShare> rows = shares_of(diagram);
    const std::size_t every = (diagram.columns.size() + 99) / 100;  // a hundred columns or fewer are listed
    std::erase_if(rows, [every](const ColumnShare& row) { return row.number % every != 0; });
    const auto units = options.scene.units();
    fmt::print("{}", units_in_words(units));
    print_table(in_units(share_table(diagram), units), std::span(rows));
    if (every > 1) fmt::print("one in {} of {} columns is listed (--json, -o)\n", every, diagram.columns.size());
    std::string shares;
    for (const auto& [mode, count] : counts)
        shares += fmt::format("{}{} {:.2f} %", shares.empty() ? "" : ", ", mode,
                              100.0 * static_cast<double>(count) / static_cast<double>(judged.size()));
    fmt::print("{} columns, {} orbits: {}\n{}", diagram.columns.size(), judged.size(), shares, chaos_in_words(judged));
    for (const RiskEvidence& evidence : diagram.risk) fmt::print("{}\n", wrapped(in_words(evidence, options.error), 2));
    if (!options.branches) return;
    print_branches(branches_of(options, diagram), diagram.along, diagram.branches);
    const std::string agreement = fmt::format(
        "{} cycles lie on stable branches (|multiplier| < 0.99): S differs by {:.1e} at most, the orbits' own last "
        "states by {:.1e}; {} lie on no branch, {} are members of families",
        diagram.agreement.compared, diagram.agreement.largest, diagram.agreement.distance, diagram.agreement.without,
        diagram.agreement.in_families);
    fmt::print("{}\n", wrapped(agreement, 4));
}

}  // namespace swirl::apps::bifurcate
