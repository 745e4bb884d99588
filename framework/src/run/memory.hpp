#pragma once

#include <string>

namespace matpoint {

/// "23.4 GB"
std::string memory_text(double bytes);

/// Bytes that this process can have at most: what the machine has free, and no more than its limits allow.
double available_memory();

/// What the particles of a scene will take, body by body, held against the memory there is before any is
/// taken: the system promises more than it has, and then ends the process without a word.
class MemoryBudget {
  public:
    MemoryBudget() : available_(available_memory()) {}

    /// Whether so much can't be had beside what was counted before.
    bool exceeded_by(double bytes) const { return taken_ + bytes > available_; }
    /// Counts a body in; throws ResourceError that says which it is, how much it takes and what to do.
    void add(const std::string& body, double particles, double bytes_per_particle);

  private:
    double available_, taken_ = 0;
};

}  // namespace matpoint
