"""The contract every posing technique fulfils: offers out, typed events in, state as plain values."""
