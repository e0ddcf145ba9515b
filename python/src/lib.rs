//! The module `organza._organza`: organza's library as Python classes. The package `organza` wraps it in the
//! interface for users.

mod cameras;
mod data;
mod error;
mod job;
mod renderer;
mod scene;
mod splats;
mod tape;
mod training;

use pyo3::prelude::*;

#[pymodule(gil_used = true)]
fn _organza(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("Error", module.py().get_type::<error::Error>())?;
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add_class::<scene::Scene>()?;
    module.add_class::<cameras::Cameras>()?;
    module.add_class::<cameras::Tiles>()?;
    module.add_class::<renderer::Renderer>()?;
    module.add_class::<renderer::DeviceScene>()?;
    module.add_class::<tape::Tape>()?;
    module.add_class::<data::Dataset>()?;
    module.add_class::<training::TrainConfig>()?;
    module.add_class::<training::Training>()?;
    module.add_function(wrap_pyfunction!(splats::export, module)?)?;
    module.add_function(wrap_pyfunction!(splats::import_splats, module)?)
}
