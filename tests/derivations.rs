//! One test for each claim of our own documents: `cargo test eq_61` runs those of equation (61).

fn main() -> std::process::ExitCode {
    rederive::harness::run(&["proofs"])
}
