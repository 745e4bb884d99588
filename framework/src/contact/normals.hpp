#pragma once

#include "contact/meeting_nodes.hpp"
#include "contact/placed_contact.hpp"

namespace matpoint {

/// Where two layers meet at a node: from the first into the second, length 1, or 0 if nothing tells.
template <class S>
typename S::Position contact_normal(const PairRule& rule, const MeetingNodes<S>& nodes, std::size_t first,
                                    std::size_t second);

/// Distance from the surface of the first to that of the second along `normal`, m; below 0 they overlap.
template <class S>
double contact_gap(const PairRule& rule, const MeetingNodes<S>& nodes, std::size_t first, std::size_t second,
                   const typename S::Position& normal, const typename S::Position& cell_size);

}  // namespace matpoint
