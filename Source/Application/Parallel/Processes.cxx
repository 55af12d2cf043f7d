// SPDX-License-Identifier: BSD-3-Clause
#include "Parallel/Processes.h"

#include "nexrad/System/Error.h"
#include "vtkNexradExchange.h"

#include <exception>

namespace nexrad::application
{

std::size_t Processes::Rank() const
{
  return controller ? static_cast<std::size_t>(controller->GetLocalProcessId()) : 0;
}

std::size_t Processes::Count() const
{
  return controller ? static_cast<std::size_t>(controller->GetNumberOfProcesses()) : 1;
}

std::pair<std::size_t, std::size_t> Processes::Part(std::size_t count) const
{
  return {count * this->Rank() / this->Count(), count * (this->Rank() + 1) / this->Count()};
}

std::vector<std::string> Processes::Exchange(const std::string& mine) const
{
  return controller ? vtkNexradExchange(controller, mine) : std::vector<std::string>{mine};
}

void Processes::Together(const std::function<void()>& work) const
{
  std::exception_ptr own;
  std::string failure; // empty: none
  try
  {
    work();
  }
  catch (const std::exception& error)
  {
    own = std::current_exception();
    failure = std::string("!") + error.what();
  }
  const std::vector<std::string> failures = this->Exchange(failure);
  if (own)
  {
    std::rethrow_exception(own);
  }
  for (const std::string& other : failures)
  {
    if (!other.empty())
    {
      throw Error(other.substr(1));
    }
  }
}

} // namespace nexrad::application
