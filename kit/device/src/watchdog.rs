//! Ends a workgroup that does not end by itself, and turns a kernel's panic into an error with its place and its invocation.
//!
//! Loops of kernels are counted, but a helper's only if it says so. The watchdog needs no help: it interrupts the thread with
//! a signal, and leaves the workgroup's stack. Where that is not possible, it ends the program.

use std::any::Any;
use std::cell::Cell;
use std::panic::{self, AssertUnwindSafe};
use std::sync::{Arc, Mutex, MutexGuard, Once, PoisonError, Weak};
use std::thread;
use std::time::{Duration, Instant};

use muslin_kernel::running;

/// How often the watchdog looks.
const PERIOD: Duration = Duration::from_millis(100);

/// A workgroup that runs.
struct Running {
    kernel: &'static str,
    since: Instant,
    limit: Duration,
}

/// A thread that runs workgroups, one after another.
struct Watched {
    thread: imp::Thread,
    running: Mutex<Option<Running>>,
}

thread_local! {
    static OWN: Arc<Watched> = watch();
}

static ALL: Mutex<Vec<Weak<Watched>>> = Mutex::new(Vec::new());

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Lets the watchdog know of this thread. The first thread starts the watchdog.
fn watch() -> Arc<Watched> {
    static STARTED: Once = Once::new();
    STARTED.call_once(|| {
        imp::prepare();
        let watchdog = thread::Builder::new().name("muslin-watchdog".to_owned());
        // without it, a kernel that does not end runs on, as on other devices
        drop(watchdog.spawn(look));
    });
    let own = Arc::new(Watched { thread: imp::Thread::current(), running: Mutex::default() });
    lock(&ALL).push(Arc::downgrade(&own));
    own
}

/// Looks at all threads, for as long as the program runs.
fn look() {
    loop {
        thread::sleep(PERIOD);
        let mut all = lock(&ALL);
        all.retain(|watched| watched.strong_count() > 0);
        for watched in all.iter().filter_map(Weak::upgrade) {
            // the thread does not end while this is locked
            let running = lock(&watched.running);
            if let Some(running) = &*running
                && running.since.elapsed() > running.limit
            {
                watched.thread.interrupt(running.kernel, running.limit);
            }
        }
    }
}

/// Runs a workgroup. Fails if that takes longer than `limit`.
pub fn run(
    limit: Duration,
    kernel: &'static str,
    workgroup: impl FnOnce() -> Result<(), String>,
) -> Result<(), String> {
    /// Clears the thread's state, also if the kernel panics.
    struct Done<'a>(&'a Watched);

    impl Drop for Done<'_> {
        fn drop(&mut self) {
            *lock(&self.0.running) = None;
        }
    }

    OWN.with(|own| {
        *lock(&own.running) = Some(Running { kernel, since: Instant::now(), limit });
        let _done = Done(own);
        imp::run(limit, workgroup)
    })
}

/// Linux on x86-64: a signal interrupts the thread.
#[cfg(all(target_os = "linux", target_arch = "x86_64"))]
mod imp {
    use std::backtrace::Backtrace;
    use std::cell::Cell;
    use std::ptr;
    use std::time::Duration;

    use corosensei::stack::DefaultStack;
    use corosensei::trap::{CoroutineTrapHandler, TrapHandlerRegs};
    use corosensei::{Coroutine, CoroutineResult};
    use muslin_kernel::{running, workgroup};

    /// Programs ignore it, unless they have asked for it.
    const SIGNAL: libc::c_int = libc::SIGURG;

    /// Stack of a workgroup, in bytes. Invocations that wait for each other have stacks of their own.
    const STACK: usize = 1 << 20;

    type Workgroup = Coroutine<(), (), Result<(), String>, DefaultStack>;

    /// When a workgroup has to be left, and how.
    struct Exit {
        trap: CoroutineTrapHandler<Result<(), String>>,
        limit: Duration,
        /// The thread's time at the end.
        deadline: Duration,
    }

    thread_local! {
        static EXIT: Cell<Option<Exit>> = const { Cell::new(None) };
        static SPARE: Cell<Option<DefaultStack>> = const { Cell::new(None) };
    }

    #[derive(Clone, Copy)]
    pub struct Thread(libc::pthread_t);

    impl Thread {
        pub fn current() -> Self {
            // SAFETY: it always succeeds
            Self(unsafe { libc::pthread_self() })
        }

        /// The thread decides itself, by the time that it has really run: a debugger may have stopped it.
        pub fn interrupt(self, _: &str, _: Duration) {
            // SAFETY: the thread runs a workgroup, so it exists
            unsafe { libc::pthread_kill(self.0, SIGNAL) };
        }
    }

    /// The time that this thread has run.
    fn own_time() -> Duration {
        let mut time = libc::timespec { tv_sec: 0, tv_nsec: 0 };
        // SAFETY: it writes to `time`
        unsafe { libc::clock_gettime(libc::CLOCK_THREAD_CPUTIME_ID, &raw mut time) };
        Duration::new(time.tv_sec as u64, time.tv_nsec as u32)
    }

    pub fn prepare() {
        // SAFETY: all zeros are an empty set of signals, and no flags
        let mut action: libc::sigaction = unsafe { std::mem::zeroed() };
        action.sa_sigaction = interrupted as *const () as usize;
        action.sa_flags = libc::SA_SIGINFO | libc::SA_RESTART;
        // SAFETY: the handler has the type that `SA_SIGINFO` asks for
        unsafe { libc::sigaction(SIGNAL, &raw const action, ptr::null_mut()) };
    }

    /// Clears the exit, also if the kernel panics.
    struct Inside;

    impl Drop for Inside {
        fn drop(&mut self) {
            EXIT.set(None);
        }
    }

    pub fn run(
        limit: Duration,
        workgroup: impl FnOnce() -> Result<(), String>,
    ) -> Result<(), String> {
        let stack = SPARE.take().or_else(|| DefaultStack::new(STACK).ok());
        let Some(stack) = stack else { return workgroup() };
        let trap = Cell::new(None);
        let body = |_: &corosensei::Yielder<(), ()>, ()| {
            let deadline = own_time() + limit;
            EXIT.set(trap.take().map(|trap| Exit { trap, limit, deadline }));
            let _inside = Inside;
            workgroup()
        };
        // SAFETY: it ends before this function does, and what it borrows lives longer
        let mut coroutine: Workgroup = unsafe { Coroutine::with_stack_unchecked(stack, body) };
        trap.set(Some(coroutine.trap_handler()));
        let result = match coroutine.resume(()) {
            CoroutineResult::Return(result) => result,
            CoroutineResult::Yield(()) => unreachable!("a workgroup does not yield"),
        };
        SPARE.set(Some(coroutine.into_stack()));
        result
    }

    /// The handler of the signal: after it, the thread goes on behind the workgroup, if its time is over.
    extern "C" fn interrupted(_: libc::c_int, _: *mut libc::siginfo_t, context: *mut libc::c_void) {
        let Some(exit) = EXIT.take() else { return };
        if own_time() < exit.deadline {
            EXIT.set(Some(exit));
            return;
        }
        let trace = Backtrace::force_capture();
        let result = move || {
            workgroup::abandon();
            let place =
                place(&trace.to_string()).map_or_else(String::new, |at| format!(", at {at}"));
            let invocation =
                running::current().map_or_else(String::new, |place| format!(", in {place}"));
            let limit = exit.limit;
            Err(format!("does not end within {limit:?}{place}{invocation}"))
        };
        // SAFETY: the coroutine runs: `EXIT` is set by it alone. A kernel owns nothing that must be dropped, and after an error
        // its outputs are not used.
        let registers = unsafe { exit.trap.setup_trap_handler(result) };
        let TrapHandlerRegs { rip, rsp, rbp, rdi, rsi } = registers;
        // SAFETY: `SA_SIGINFO` handlers get a context of this type
        let context = unsafe { &mut *context.cast::<libc::ucontext_t>() };
        let values = [
            (libc::REG_RIP, rip),
            (libc::REG_RSP, rsp),
            (libc::REG_RBP, rbp),
            (libc::REG_RDI, rdi),
            (libc::REG_RSI, rsi),
        ];
        for (register, value) in values {
            context.uc_mcontext.gregs[register as usize] = value as i64;
        }
    }

    /// The place of the first frame under the signal's handler that has a source which is not Rust's own.
    fn place(trace: &str) -> Option<String> {
        let (_, under) = trace.split_once("interrupted")?;
        let places = under.lines().filter_map(|line| line.trim().strip_prefix("at "));
        // the first one is the handler's
        let place = places.skip(1).find(|place| !place.starts_with("/rustc/"))?;
        Some(place.trim_start_matches("./").to_owned())
    }
}

/// Elsewhere, the watchdog can only end the program.
#[cfg(not(all(target_os = "linux", target_arch = "x86_64")))]
mod imp {
    use std::time::Duration;

    pub struct Thread;

    impl Thread {
        pub fn current() -> Self {
            Self
        }

        pub fn interrupt(&self, kernel: &str, limit: Duration) {
            eprintln!("error: kernel `{kernel}`: a workgroup does not end within {limit:?}");
            std::process::exit(2);
        }
    }

    pub fn prepare() {}

    pub fn run(_: Duration, workgroup: impl FnOnce() -> Result<(), String>) -> Result<(), String> {
        workgroup()
    }
}

thread_local! {
    /// The place of the thread's last panic.
    static LOCATION: Cell<Option<String>> = const { Cell::new(None) };
}

/// Suppresses the output of kernels' panics, which are returned as errors. With `RUST_BACKTRACE` they are still
/// printed.
pub fn install() {
    static INSTALLED: Once = Once::new();
    INSTALLED.call_once(|| {
        let wants_backtrace = std::env::var_os("RUST_BACKTRACE").is_some_and(|value| value != "0");
        let previous = panic::take_hook();
        panic::set_hook(Box::new(move |panic| {
            if running::current().is_none() || wants_backtrace {
                previous(panic);
            }
            LOCATION.set(panic.location().map(ToString::to_string));
        }));
    });
}

/// Runs workgroups, each of which calls [`running::begin`].
pub fn supervise(workgroups: impl FnOnce() -> Result<(), String>) -> Result<(), String> {
    let result = panic::catch_unwind(AssertUnwindSafe(workgroups));
    let result = result.unwrap_or_else(|payload| Err(describe(payload.as_ref())));
    running::begin(None);
    result
}

fn describe(payload: &(dyn Any + Send)) -> String {
    let mut text = payload
        .downcast_ref::<String>()
        .map(String::as_str)
        .or_else(|| payload.downcast_ref::<&str>().copied())
        .unwrap_or("it panicked")
        .to_owned();
    if let Some(location) = LOCATION.take() {
        text += &format!(", at {location}");
    }
    if let Some(place) = running::current() {
        text += &format!(", in {place}");
    }
    text
}
