// SPDX-License-Identifier: GPL-3.0-or-later
// neuralmesh._core: what the Python package neuralmesh is made of.
#include <nanobind/nanobind.h>

#include "interruptible.h"
#include "lzf.h"
#include "neuralmesh/errors.h"
#include "run.h"
#include "target.h"

namespace nb = nanobind;

NB_MODULE(_core, module)
{
    module.doc() = "Private: the C++ core. Use the functions of neuralmesh.";
    module.attr("__version__") = NEURALMESH_VERSION;
    nb::exception<neuralmesh::InvalidInput>(module, "InvalidInput", PyExc_ValueError).doc() =
        "The input or a parameter cannot be used; the message says why.";
    nb::exception<neuralmesh::Cancelled>(module, "Cancelled", PyExc_RuntimeError).doc() =
        "The progress callback returned False.";
    neuralmesh::python::defineTargets(module);
    neuralmesh::python::defineReconstruction(module);
    module.def("lzf_decompressed", neuralmesh::python::lzfDecompressed, nb::arg("packed"),
               nb::arg("size"));
    module.def("join_abandoned", neuralmesh::python::joinAbandoned,
               "Wait for cancelled work to end.");
}
