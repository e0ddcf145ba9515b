//! Ranks that communicate through Python.

use std::sync::atomic::{AtomicU64, Ordering};

use numpy::{Element, IntoPyArray, PyArray1, PyArrayMethods, PyReadonlyArray1};
use organza::ranks::Ranks;
use organza::{Error, Result};
use pyo3::prelude::*;

/// Flips the bit that makes the order of `u32` the order of `i32`.
const TOP: u32 = 1 << 31;

/// A rank that is a process. A Python object sends its messages, which are numpy arrays: see `organza/_ranks.py`.
#[derive(Debug)]
pub struct PythonRanks {
    carrier: Py<PyAny>,
    rank: usize,
    size: usize,
    /// Whether ranks may differ in program and device.
    pub mixed: bool,
    sent: AtomicU64,
}

impl PythonRanks {
    pub fn new(carrier: &Bound<'_, PyAny>) -> PyResult<Self> {
        Ok(Self {
            rank: carrier.getattr("rank")?.extract()?,
            size: carrier.getattr("size")?.extract()?,
            mixed: carrier.getattr("mixed")?.extract()?,
            carrier: carrier.clone().unbind(),
            sent: 0.into(),
        })
    }

    /// Makes a call. If it fails, the Python object knows which rank has failed. Otherwise this rank cannot reach the
    /// others.
    fn call<T>(&self, call: impl FnOnce(&Bound<'_, PyAny>) -> PyResult<T>) -> Result<T> {
        Python::attach(|py| {
            let carrier = self.carrier.bind(py);
            call(carrier).map_err(|error| {
                let failed = carrier.getattr("failed").and_then(|failed| failed.extract());
                let (rank, message) = match failed {
                    Ok(Some(failed)) => failed,
                    _ => (self.rank, error.value(py).to_string()),
                };
                Error::Rank { rank, message }
            })
        })
    }

    fn count(&self, bytes: usize) {
        self.sent.fetch_add(bytes as u64, Ordering::Relaxed);
    }

    /// Combines the values of all ranks, element by element.
    fn reduce<T: Element>(
        &self,
        values: Vec<T>,
        operation: &str,
        take: impl FnOnce(&[T]),
    ) -> Result<()> {
        self.count(size_of_val(&values[..]));
        self.call(|carrier| {
            let values = values.into_pyarray(carrier.py());
            carrier.call_method1("reduce", (&values, operation))?;
            take(values.readonly().as_slice()?);
            Ok(())
        })
    }

    /// `reduce` for values of a type that torch does not have. `turn` converts them and back.
    fn reduce_words(&self, values: &mut [u32], operation: &str, turn: u32) -> Result<()> {
        let turned = values.iter().map(|value| (value ^ turn) as i32).collect();
        self.reduce(turned, operation, |found| {
            let found = found.iter().map(|&value| value as u32 ^ turn);
            values.iter_mut().zip(found).for_each(|(value, found)| *value = found);
        })
    }
}

/// The bytes from each rank.
fn messages(list: Bound<'_, PyAny>) -> PyResult<Vec<Vec<u8>>> {
    let arrays: Vec<PyReadonlyArray1<'_, u8>> = list.extract()?;
    arrays.iter().map(|array| Ok(array.as_slice()?.to_vec())).collect()
}

impl Ranks for PythonRanks {
    fn rank(&self) -> usize {
        self.rank
    }

    fn size(&self) -> usize {
        self.size
    }

    fn max(&self, values: &mut [u32]) -> Result<()> {
        self.reduce_words(values, "max", TOP)
    }

    fn or(&self, values: &mut [u32]) -> Result<()> {
        self.reduce_words(values, "or", 0)
    }

    fn sum(&self, values: &mut [i64]) -> Result<()> {
        self.reduce(values.to_vec(), "sum", |found| values.copy_from_slice(found))
    }

    fn gather(&self, mine: Vec<u8>) -> Result<Vec<Vec<u8>>> {
        self.count(mine.len());
        self.call(|carrier| {
            let mine = mine.into_pyarray(carrier.py());
            messages(carrier.call_method1("gather", (mine,))?)
        })
    }

    fn exchange(&self, for_each: Vec<Vec<u8>>) -> Result<Vec<Vec<u8>>> {
        self.count(for_each.iter().map(Vec::len).sum());
        self.call(|carrier| {
            let for_each: Vec<Bound<'_, PyArray1<u8>>> =
                for_each.into_iter().map(|bytes| bytes.into_pyarray(carrier.py())).collect();
            messages(carrier.call_method1("exchange", (for_each,))?)
        })
    }

    fn broadcast(&self, mine: Vec<u8>) -> Result<Vec<u8>> {
        let mine = if self.rank == 0 { mine } else { Vec::new() };
        self.count(mine.len());
        self.call(|carrier| {
            let mine = mine.into_pyarray(carrier.py());
            let found = carrier.call_method1("broadcast", (mine,))?;
            let found: PyReadonlyArray1<'_, u8> = found.extract()?;
            Ok(found.as_slice()?.to_vec())
        })
    }

    fn fail(&self, message: &str) {
        // a rank that does not get the message notices that this process has ended
        let _ = self.call(|carrier| carrier.call_method1("fail", (message,)).map(drop));
    }

    fn sent(&self) -> u64 {
        self.sent.load(Ordering::Relaxed)
    }
}

/// If a rank panics, it reports that, or the others would wait for it.
impl Drop for PythonRanks {
    fn drop(&mut self) {
        if std::thread::panicking() {
            self.fail("it has panicked");
        }
    }
}
