// A record's values as text.
#pragma once

#include "apps/show/record_tables.hpp"

#include <string>

namespace swirl::apps::show {

/// Numbers as the shortest decimals that read back to the same double, lists with blanks between.
std::string text_of_value(const Value& value);
/// Numbers with ten digits, for people.
std::string short_text_of(const Value& value);

/// "points_psi": of a value of a row.
std::string heading_of_value(const ShownColumn& column, const std::string& label);

/// HDF5 lists attributes by name: those of a scene or start go into the order of documents, before the others.
NamedValues in_written_order(const NamedValues& values);

}  // namespace swirl::apps::show
