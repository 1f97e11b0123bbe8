// The risk at which chaos is called before the limits: its flag, and what a document, a record and people are told.
#pragma once

#include "apps/command_line/documents.hpp"
#include "apps/command_line/flags.hpp"
#include "apps/record/record_reader.hpp"
#include "apps/studies/modes/early_chaos.hpp"

#include <string>
#include <vector>

namespace swirl::apps {

using studies::RiskEvidence;

/// --risk P: 0 or more, below 1; `risk` keeps what is not given.
void add_risk_flag(Flags& command, double& risk);

/// Where all impacts are asked for none can be left out. @throws BadInput
void require_no_risk_of_all(double risk, bool exhaustive);

/// Member `risk_evidence`, a list: runs, impacts, least_exponent, followed, judged, changed, bound.
void write_risk(JsonWriter& json, const std::vector<RiskEvidence>& evidence);
/// The same as a group of this name, with what is assumed; nothing where there is none.
void write_risk(const RecordGroup& root, const std::vector<RiskEvidence>& evidence);
/// From a record; none where it has no such group. @throws RecordError
std::vector<RiskEvidence> read_risk(const RecordReader& record);

/// A line for people.
std::string in_words(const RiskEvidence& evidence);

}  // namespace swirl::apps
