"""The paper's table and figures: what it reports, our runs, pictures, and the page of all."""
