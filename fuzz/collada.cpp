// SPDX-License-Identifier: BSD-3-Clause
// COLLADA files, as they are looked over before Assimp reads them.
#include "ColladaFile.h"
#include "FuzzInput.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    try
    {
        specplan::problems::inspectCollada("mesh.dae", {reinterpret_cast<const char*>(data), size});
    }
    catch (const specplan::problems::InputError& error)
    {
        specplan::fuzz::requireOneLine(error.what());
    }
    return 0;
}
