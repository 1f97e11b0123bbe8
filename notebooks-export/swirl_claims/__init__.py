"""What the paper that started Swirl says of its simulations, run again with error bars (docs/references.md, Sun 2019)."""
