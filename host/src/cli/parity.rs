//! `organza parity`: compares every kernel on this machine's GPUs with the CPU.

use std::process::ExitCode;

use muslin_check::Report;
use muslin_device::{AdapterInfo, adapters};
use organza::error::{DeviceError, chain};
use organza::{DeviceOptions, Error, MODULES, Result, SpirvPath};
use organza_parity::cases;

use super::console::{Console, print, print_json};

/// The exit code if a kernel is out of tolerance.
const OUT_OF_TOLERANCE: u8 = 1;

/// Run every kernel on every GPU and compare with the CPU: run this first on a new GPU
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("help/parity.txt"))]
pub struct Args {
    /// Only use GPUs whose name contains this text [default: all]
    #[arg(long, value_name = "NAME")]
    adapter: Option<String>,
    /// Print JSON, with the place of each largest difference
    #[arg(long)]
    json: bool,
}

pub fn run(args: &Args, console: Console) -> Result<ExitCode> {
    let cpu = organza::open_device(&DeviceOptions::cpu(None))?;
    let mut reports = Vec::new();
    let mut unusable = Vec::new();
    let cases = cases();
    for adapter in chosen(args.adapter.as_deref())? {
        for path in paths(&adapter) {
            let what = format!("{}, {}", adapter.name, path.as_str());
            let progress = console.progress(&what, cases.len(), "kernels");
            let done = |_| progress.advance(1);
            match Report::run_on_gpu(&cases, &MODULES, &cpu, &adapter, path, done) {
                Ok(report) => reports.push(report),
                // another GPU may be usable
                Err(error @ DeviceError::NoGpu { .. }) => unusable.push(Error::Device(error)),
                Err(error) => return Err(error.into()),
            }
        }
    }
    if reports.is_empty()
        && let Some(error) = unusable.pop()
    {
        return Err(error);
    }
    unusable.iter().for_each(|error| console.warn(&chain(error)));
    if args.json {
        print_json(&reports)?;
    } else {
        let texts: Vec<_> = reports.iter().map(Report::to_string).collect();
        print(&texts.join("\n"))?;
    }
    let is_ok = reports.iter().all(Report::is_ok);
    console.note(match is_ok {
        true => "all kernels agree with the CPU",
        false => "some kernels are out of tolerance: look for FAILED",
    });
    Ok(if is_ok { ExitCode::SUCCESS } else { ExitCode::from(OUT_OF_TOLERANCE) })
}

/// The adapters whose name contains `name`, or all without a name.
fn chosen(name: Option<&str>) -> Result<Vec<AdapterInfo>> {
    let wanted = name.unwrap_or("").to_lowercase();
    let mut found = adapters();
    found.retain(|adapter| adapter.name.to_lowercase().contains(&wanted));
    if found.is_empty() {
        // opening it reports why it cannot be used
        let adapter = name.map(str::to_owned);
        organza::open_device(&DeviceOptions::gpu(SpirvPath::Naga).adapter(adapter))?;
        return Err(DeviceError::NoGpu { reason: "it has just disappeared".into() }.into());
    }
    Ok(found)
}

fn paths(adapter: &AdapterInfo) -> Vec<SpirvPath> {
    if adapter.passes_through {
        vec![SpirvPath::Passthrough, SpirvPath::Naga]
    } else {
        vec![SpirvPath::Naga]
    }
}
