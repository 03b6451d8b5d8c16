//! What a long run tells whoever waits for it, and how it is asked to stop.
//!
//! Work comes in units: a document, a point of the floating-point comparison. Before each unit a run
//! looks whether it shall [stop](Watch::stop); what is finished by then is kept and reported. Nothing
//! that is printed or written depends on a watch that does not stop.

use indicatif::{ProgressBar, ProgressStyle};
use std::io::{IsTerminal, Write};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

/// Follows a run.
pub trait Watch {
    /// Work of so many units begins.
    fn begin(&self, what: &str, units: usize);
    /// One more unit is done.
    fn advance(&self);
    /// The work that began last has ended.
    fn end(&self);
    /// Whether the run shall stop before its next unit.
    fn stop(&self) -> bool;
}

/// Says nothing and never stops.
#[derive(Clone, Copy, Debug)]
pub struct Unwatched;

impl Watch for Unwatched {
    fn begin(&self, _: &str, _: usize) {}
    fn advance(&self) {}
    fn end(&self) {}
    fn stop(&self) -> bool {
        false
    }
}

/// Whether Ctrl-C was pressed.
static INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// Whether what was found is being printed.
static PRINTING: AtomicBool = AtomicBool::new(false);

/// How long after Ctrl-C a run has to end by itself.
const GRACE: Duration = Duration::from_millis(900);

/// Says that what was found is printed from now on.
pub fn printing() {
    PRINTING.store(true, Ordering::SeqCst);
}

/// Whether a long search shall end with what it has: it is asked within it, far oftener than once a second.
pub fn interrupted() -> bool {
    INTERRUPTED.load(Ordering::Relaxed)
}

/// The exit code of an interrupted run: 128 and the number of the signal.
pub const INTERRUPTED_CODE: u8 = 130;

/// A bar on the terminal, and Ctrl-C. Where standard error is no terminal there is no bar.
#[derive(Debug)]
pub struct Terminal {
    bar: Mutex<Option<ProgressBar>>,
}

impl Terminal {
    /// Begins to watch: from now on the first Ctrl-C asks the run to stop, a second one ends the
    /// process.
    pub fn new() -> Self {
        // A second handler in one process is refused; the first one does the same.
        let _ = ctrlc::set_handler(|| {
            // What computes exactly ends in the middle of it.
            ratpoly::allowance::interrupt();
            if INTERRUPTED.swap(true, Ordering::SeqCst) {
                std::process::exit(INTERRUPTED_CODE.into());
            }
            // What looks for neither of the two ends with the process, unless results are being printed.
            std::thread::spawn(|| {
                std::thread::sleep(GRACE);
                if !PRINTING.load(Ordering::SeqCst) {
                    eprintln!("interrupted: nothing was finished");
                    std::process::exit(INTERRUPTED_CODE.into());
                }
            });
        });
        Terminal {
            bar: Mutex::new(None),
        }
    }

    /// Whether Ctrl-C was pressed.
    pub fn interrupted(&self) -> bool {
        INTERRUPTED.load(Ordering::SeqCst)
    }

    /// Writes a line to standard error, above the bar if there is one.
    pub fn say(&self, line: &str) {
        self.with_bar(|bar| match bar {
            Some(bar) => bar.println(line),
            None => {
                // Nobody listens any more; the run goes on.
                let _ = writeln!(std::io::stderr(), "{line}");
            }
        });
    }

    fn with_bar(&self, change: impl FnOnce(&mut Option<ProgressBar>)) {
        if let Ok(mut bar) = self.bar.lock() {
            change(&mut bar);
        }
    }
}

impl Default for Terminal {
    fn default() -> Self {
        Terminal::new()
    }
}

impl Watch for Terminal {
    fn begin(&self, what: &str, units: usize) {
        if !std::io::stderr().is_terminal() {
            return;
        }
        self.with_bar(|bar| {
            let new = ProgressBar::new(units as u64);
            if let Ok(style) =
                ProgressStyle::with_template("{spinner} {msg} {wide_bar} {pos}/{len}")
            {
                new.set_style(style);
            }
            new.set_message(what.to_string());
            new.enable_steady_tick(Duration::from_millis(120));
            if let Some(old) = bar.replace(new) {
                old.finish_and_clear();
            }
        });
    }

    fn advance(&self) {
        self.with_bar(|bar| {
            if let Some(bar) = bar {
                bar.inc(1);
            }
        });
    }

    fn end(&self) {
        self.with_bar(|bar| {
            if let Some(bar) = bar.take() {
                bar.finish_and_clear();
            }
        });
    }

    fn stop(&self) -> bool {
        self.interrupted()
    }
}
