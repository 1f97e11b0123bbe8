// Where impacts go as they come: a table, JSON, a record. Nothing is kept.
#pragma once

#include "apps/command_line/documents.hpp"
#include "apps/simulate/impact_row.hpp"

#include <memory>
#include <vector>

namespace swirl::apps {

/// Writes "collisions": [...] into an open JSON object.
class JsonImpacts {
public:
    JsonImpacts(JsonWriter& json, bool disk);
    void add(const ImpactRow& row);
    void finish();

private:
    JsonWriter& json_;
    bool disk_;
};

/// Prints aligned columns to standard output.
class TableImpacts {
public:
    explicit TableImpacts(bool disk);
    void add(const ImpactRow& row);

private:
    bool disk_;
};

/// Group `collisions` of a record, dimension `collision`.
class RecordImpacts {
public:
    RecordImpacts(RecordGroup group, bool disk);
    void add(const ImpactRow& row);

private:
    struct NamedColumn {
        double ImpactRow::*member;
        Column<double> column;
    };
    std::vector<NamedColumn> numbers_;
    std::vector<Column<std::int64_t>> index_;
    std::vector<Column<std::int32_t>> vertex_;
    std::vector<Column<std::uint8_t>> mode_;
    std::vector<Column<bool>> simultaneous_;
};

}  // namespace swirl::apps
